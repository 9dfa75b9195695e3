//! Tests of the reader: shipped studies, the documented example, malformed files.
