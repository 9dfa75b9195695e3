//! Printing to a reader who may have left, as in `signorini list | head`: what cannot be written is dropped, and the
//! exit status still tells the verdict. The standard macros would panic.

use std::fmt::Arguments;
use std::io::Write;

/// Writes what can be written.
pub fn to(mut stream: impl Write, text: Arguments) {
    let _ = stream.write_fmt(text);
}

/// `print!` to standard output.
macro_rules! say {
    ($($text:tt)*) => { $crate::say::to(std::io::stdout(), format_args!($($text)*)) };
}

/// `println!` to standard output.
macro_rules! sayln {
    ($($text:tt)*) => { say!("{}\n", format_args!($($text)*)) };
}

/// `print!` to standard error.
macro_rules! complain {
    ($($text:tt)*) => { $crate::say::to(std::io::stderr(), format_args!($($text)*)) };
}
