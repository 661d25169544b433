//! Percent-encoding (RFC 3986, § 2.1): whatever could mean something in an address is written as `%` and two digits.

/// A word as a value of a link.
pub fn encoded(text: &str) -> String {
    encode(text, "")
}

/// A name of a scene, in which `/` and `:` stay readable.
pub fn encoded_path(text: &str) -> String {
    encode(text, "/:")
}

fn encode(text: &str, also_plain: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for &byte in text.as_bytes() {
        let character = char::from(byte);
        // The unreserved characters of § 2.3, without `~`, `*` and what shells or Markdown would take for their own.
        if byte.is_ascii_alphanumeric() || "-._".contains(character) || also_plain.contains(character) {
            out.push(character);
        } else {
            out.push('%');
            out.extend([byte >> 4, byte & 15].map(digit));
        }
    }
    out
}

fn digit(value: u8) -> char {
    char::from_digit(u32::from(value), 16).unwrap_or('0').to_ascii_uppercase()
}

/// The text that was encoded.
///
/// # Errors
/// Where a `%` is not followed by two hexadecimal digits, or what comes out is not UTF-8.
pub fn decoded(text: &str) -> Result<String, String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let mut hexadecimal = || rest.next().and_then(|digit| char::from(digit).to_digit(16));
        let value = hexadecimal().zip(hexadecimal()).and_then(|(high, low)| u8::try_from(16 * high + low).ok());
        bytes.push(value.ok_or_else(|| format!("`{text}` has a % without two hexadecimal digits after it"))?);
    }
    String::from_utf8(bytes).map_err(|_| format!("`{text}` is not UTF-8 once its % signs are resolved"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_that_mean_something_are_hidden_and_come_back() {
        let text = "my scene/50% & more?#π=\u{1F600}";
        let hidden = encoded_path(text);
        assert!(hidden.starts_with("my%20scene/50%25%20%26%20more%3F%23%CF%80%3D"));
        assert_eq!(decoded(&hidden).as_deref(), Ok(text));
    }

    #[test]
    fn a_percent_sign_alone_is_refused() {
        for wrong in ["%", "%4", "%zz", "100%", "%é1"] {
            assert!(decoded(wrong).unwrap_err().contains("hexadecimal"), "{wrong}");
        }
        assert!(decoded("%FF").unwrap_err().contains("UTF-8"));
    }
}
