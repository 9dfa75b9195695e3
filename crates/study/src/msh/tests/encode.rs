//! The binary form of a text, number by number: a writer for tests, independent of the reader.

/// How a number of a section is written: `i32`, `u64`, `f64`.
#[derive(Clone, Copy)]
enum Kind {
    Int,
    Size,
    Real,
}
use Kind::{Int, Real, Size};

struct Encoder<'a> {
    words: std::str::SplitWhitespace<'a>,
    bytes: Vec<u8>,
    big: bool,
}

impl Encoder<'_> {
    /// Takes the next word over; its value as a whole number where it is one.
    fn put(&mut self, kind: Kind) -> usize {
        let word = self.words.next().unwrap();
        let mut bytes = match kind {
            Int => word.parse::<i32>().unwrap().to_be_bytes().to_vec(),
            Size => word.parse::<u64>().unwrap().to_be_bytes().to_vec(),
            Real => word.parse::<f64>().unwrap().to_be_bytes().to_vec(),
        };
        if !self.big {
            bytes.reverse();
        }
        self.bytes.extend(bytes);
        word.parse().unwrap_or(0)
    }

    fn all(&mut self, kinds: &[Kind]) -> usize {
        kinds.iter().map(|k| self.put(*k)).last().unwrap()
    }

    fn many(&mut self, kind: Kind) {
        let count = self.put(Size);
        (0..count).for_each(|_| _ = self.put(kind));
    }

    fn entities(&mut self) {
        let counts = [0; 4].map(|_| self.put(Size));
        for (dimension, count) in counts.into_iter().enumerate() {
            for _ in 0..count {
                self.put(Int);
                (0..if dimension == 0 { 3 } else { 6 }).for_each(|_| _ = self.put(Real));
                (0..if dimension == 0 { 1 } else { 2 }).for_each(|_| self.many(Int));
            }
        }
    }

    fn nodes(&mut self) {
        let blocks = self.put(Size);
        self.all(&[Size, Size, Size]);
        for _ in 0..blocks {
            let count = self.all(&[Int, Int, Int, Size]);
            (0..count).for_each(|_| _ = self.put(Size));
            (0..3 * count).for_each(|_| _ = self.put(Real));
        }
    }

    fn elements(&mut self) {
        let blocks = self.put(Size);
        self.all(&[Size, Size, Size]);
        for _ in 0..blocks {
            let kind = self.all(&[Int, Int, Int]);
            let count = self.put(Size);
            let nodes = [0, 2, 3][kind];
            (0..count * (1 + nodes)).for_each(|_| _ = self.put(Size));
        }
    }
}

/// The text as a binary file, highest byte first if `big`. Sections as [`super::super::write()`] makes them.
pub fn binary(text: &str, big: bool) -> Vec<u8> {
    let one = if big { 1_i32.to_be_bytes() } else { 1_i32.to_le_bytes() };
    let mut bytes = [b"$MeshFormat\n4.1 1 8\n", &one[..], b"\n$EndMeshFormat\n"].concat();
    for section in text.split("\n$End").filter_map(|s| s.split_once('$').map(|(_, s)| s)) {
        let (name, body) = section.split_once('\n').unwrap();
        let mut encoder = Encoder { words: body.split_whitespace(), bytes: Vec::new(), big };
        match name {
            "MeshFormat" => continue,
            "PhysicalNames" => encoder.bytes.extend(body.bytes()),
            "Entities" => encoder.entities(),
            "Nodes" => encoder.nodes(),
            "Elements" => encoder.elements(),
            other => panic!("{other}"),
        }
        bytes.extend([format!("${name}\n").as_bytes(), &encoder.bytes, format!("\n$End{name}\n").as_bytes()].concat());
    }
    bytes
}
