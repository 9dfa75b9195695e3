//! The name of a mesh: equal meshes, to the last bit, have equal names on every machine.

use super::{Body, Mesh};

impl Mesh {
    /// FNV-1a (64 bits) over everything in the mesh, as 16 hexadecimal digits: coordinates by their bit patterns, then
    /// triangles, bodies, sides, parts and contact sides, each list after its length, integers as little-endian `u64`; then
    /// the curved sides, if there are any.
    ///
    /// G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake: *The FNV Non-Cryptographic Hash Algorithm*. It tells meshes apart by
    /// accident, not against malice.
    pub fn hash(&self) -> String {
        let mut hash = Fnv1a::default();
        hash.list(&self.points, |h, p| h.numbers([p.x.to_bits(), p.y.to_bits()]));
        hash.list(&self.node_bodies, |h, b| h.numbers([b.index() as u64]));
        hash.list(&self.triangles, |h, t| h.numbers(t.map(u64::from)));
        hash.numbers([self.first_triangles as u64]);
        hash.list(&self.sides, |h, s| {
            h.numbers(s.nodes.map(u64::from));
            h.numbers([u64::from(s.triangle), u64::from(s.part)]);
        });
        hash.list(&self.parts, |h, p| {
            h.numbers([u64::from(p.body == Body::Second), p.name.len() as u64]);
            h.bytes(p.name.as_bytes());
        });
        hash.list(&self.contact, |h, c| {
            h.numbers(c.first.map(u64::from));
            h.numbers(c.second.map(u64::from));
            h.numbers([u64::from(c.segment)]);
        });
        if !self.curved.sides.is_empty() {
            self.add_curved(&mut hash);
        }
        format!("{:016x}", hash.0)
    }

    fn add_curved(&self, hash: &mut Fnv1a) {
        hash.bytes(format!("{:?}", self.curved.element).as_bytes());
        hash.list(&self.curved.curves, |h, c| h.bytes(c.describe().as_bytes()));
        hash.list(&self.curved.sides, |h, s| {
            h.numbers([u64::from(s.triangle), u64::from(s.apex), u64::from(s.curve)]);
            h.numbers(s.span.map(f64::to_bits));
        });
    }
}

/// FNV-1a (64 bits) of a string of bytes.
pub fn fnv1a(bytes: &[u8]) -> u64 {
    let mut hash = Fnv1a::default();
    hash.bytes(bytes);
    hash.0
}

const PRIME: u64 = 0x0100_0000_01b3;

/// State of FNV-1a with 64 bits.
pub(super) struct Fnv1a(pub u64);

impl Default for Fnv1a {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv1a {
    pub fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            // hash ← (hash xor byte) · prime
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(PRIME);
        }
    }

    fn numbers<const N: usize>(&mut self, numbers: [u64; N]) {
        for number in numbers {
            let [low, high] = [number as u32, (number >> 32) as u32];
            self.bytes(&low.to_le_bytes());
            if high == 0 {
                // (hash xor 0) · prime, four times
                self.0 = self.0.wrapping_mul(PRIME.wrapping_pow(4));
            } else {
                self.bytes(&high.to_le_bytes());
            }
        }
    }

    fn list<T>(&mut self, items: &[T], mut item: impl FnMut(&mut Self, &T)) {
        self.numbers([items.len() as u64]);
        for i in items {
            item(self, i);
        }
    }
}
