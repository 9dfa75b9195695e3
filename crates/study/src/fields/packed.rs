//! Arrays of numbers as bytes, little-endian, and as base64 text: bit for bit, and half as long as decimals.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

/// A number, or a row of them.
pub trait Packed: Sized {
    /// Bytes that it takes.
    const BYTES: usize;
    /// How NumPy names the type of its numbers.
    const NUMPY: &'static str;
    /// How VTK names it.
    const VTK: &'static str;
    /// Numbers in a row.
    const COMPONENTS: usize;
    /// Appends its bytes.
    fn put(&self, bytes: &mut Vec<u8>);
    /// Reads it from exactly [`Packed::BYTES`] bytes.
    fn take(bytes: &[u8]) -> Self;
}

macro_rules! number {
    ($type:ty, $numpy:literal, $vtk:literal) => {
        impl Packed for $type {
            const BYTES: usize = size_of::<$type>();
            const NUMPY: &'static str = $numpy;
            const VTK: &'static str = $vtk;
            const COMPONENTS: usize = 1;

            fn put(&self, bytes: &mut Vec<u8>) {
                bytes.extend(self.to_le_bytes());
            }

            fn take(bytes: &[u8]) -> Self {
                let mut own = [0; size_of::<$type>()];
                own.copy_from_slice(bytes);
                Self::from_le_bytes(own)
            }
        }
    };
}

number!(f64, "<f8", "Float64");
number!(u32, "<u4", "UInt32");
number!(i64, "<i8", "Int64");
number!(u8, "|u1", "UInt8");

impl<T: Packed, const N: usize> Packed for [T; N] {
    const BYTES: usize = N * T::BYTES;
    const NUMPY: &'static str = T::NUMPY;
    const VTK: &'static str = T::VTK;
    const COMPONENTS: usize = N * T::COMPONENTS;

    fn put(&self, bytes: &mut Vec<u8>) {
        self.iter().for_each(|x| x.put(bytes));
    }

    fn take(bytes: &[u8]) -> Self {
        std::array::from_fn(|k| T::take(&bytes[k * T::BYTES..(k + 1) * T::BYTES]))
    }
}

/// The bytes of a list.
pub fn bytes<T: Packed>(list: &[T]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(list.len() * T::BYTES);
    list.iter().for_each(|x| x.put(&mut bytes));
    bytes
}

/// Writes a list as base64 text.
pub fn serialize<T: Packed, S: Serializer>(list: &[T], to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&base64(&bytes(list)))
}

/// Reads what [`serialize`] wrote.
pub fn deserialize<'de, T: Packed, D: Deserializer<'de>>(from: D) -> Result<Vec<T>, D::Error> {
    let text = String::deserialize(from)?;
    let bytes = from_base64(&text).ok_or_else(|| D::Error::custom("an array that is no base64"))?;
    if bytes.len() % T::BYTES != 0 {
        let message = format!("an array of {} bytes, which is no multiple of {}", bytes.len(), T::BYTES);
        return Err(D::Error::custom(message));
    }
    Ok(bytes.chunks_exact(T::BYTES).map(T::take).collect())
}

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// RFC 4648, with padding.
pub fn base64(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let at = |k: usize| u32::from(three.get(k).copied().unwrap_or(0));
        let word = at(0) << 16 | at(1) << 8 | at(2);
        for k in 0..4 {
            let letter = ALPHABET[(word >> (18 - 6 * k) & 63) as usize];
            text.push(if k <= three.len() { char::from(letter) } else { '=' });
        }
    }
    text
}

/// The bytes of a text with padding; none if it is no base64.
pub fn from_base64(text: &str) -> Option<Vec<u8>> {
    let mut value = [None; 256];
    ALPHABET.iter().zip(0_u32..).for_each(|(letter, k)| value[usize::from(*letter)] = Some(k));
    let letters = text.as_bytes();
    let body = text.trim_end_matches('=').len();
    if !letters.len().is_multiple_of(4) || letters.len() - body > 2 {
        return None;
    }
    let mut bytes = Vec::with_capacity(letters.len() / 4 * 3);
    for four in letters[..body].chunks(4) {
        let mut word = 0;
        for k in 0..4 {
            word = word << 6 | four.get(k).map_or(Some(0), |letter| value[usize::from(*letter)])?;
        }
        bytes.extend([word >> 16, word >> 8, word].iter().take(four.len() - 1).map(|b| *b as u8));
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples of RFC 4648, section 10.
    #[test]
    fn base64_is_that_of_the_standard() {
        let pairs =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (plain, coded) in pairs {
            assert_eq!(base64(plain.as_bytes()), coded);
            assert_eq!(from_base64(coded).as_deref(), Some(plain.as_bytes()));
        }
        let all: Vec<u8> = (0..=255).collect();
        assert_eq!(from_base64(&base64(&all)), Some(all));
        for broken in ["Zg=", "Zg", "Z===", "Zm9*"] {
            assert_eq!(from_base64(broken), None, "{broken}");
        }
    }

    #[test]
    fn lists_come_back_bit_for_bit() {
        let list = vec![[0.1, -0.0, f64::MIN_POSITIVE], [1e300, 1.0 / 3.0, 5e-324]];
        let text = serde_json::to_string(&Wrapped { list: list.clone() }).unwrap();
        let back: Wrapped = serde_json::from_str(&text).unwrap();
        assert!(back.list.iter().flatten().zip(list.iter().flatten()).all(|(a, b)| a.to_bits() == b.to_bits()));
        assert!(serde_json::from_str::<Wrapped>(r#"{"list":"Zm9v"}"#).is_err(), "three bytes are no number");
    }

    #[derive(serde::Serialize, Deserialize)]
    struct Wrapped {
        #[serde(with = "super")]
        list: Vec<[f64; 3]>,
    }
}
