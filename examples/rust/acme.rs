// SPDX-License-Identifier: MIT-0
//
// A subject in Rust, one file without crates: straight lines of RS274 in millimetres, absolute (G0 and G1 with X, Y,
// Z and F, M2). Numbers stay the text that they were, so that nothing is rounded. Without M2 the last line alarms.
// Any other word, or a profile that is not the default one, is not supported: exit 3.
// It is called as: acme --dialect rs274 --profile FILE.json
use std::io::Read;
use std::process::exit;

/// A decimal without its sign +, blanks or a leading point: what JSON of the records wants.
fn decimal(text: &str) -> Option<String> {
    let (sign, digits) = match text.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", text.strip_prefix('+').unwrap_or(text)),
    };
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let known = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if !known(whole) || !known(part) || whole.len() + part.len() == 0 {
        return None;
    }
    let whole = if whole.is_empty() { "0" } else { whole };
    let point = if part.is_empty() { "" } else { "." };
    Some(format!("{sign}{whole}{point}{part}"))
}

/// The words of a line as (letter, number); None: something that this example does not read.
fn words_of(line: &str) -> Option<Vec<(char, String)>> {
    let text: String = line.chars().filter(|c| !c.is_whitespace()).collect();
    let text = text.to_ascii_uppercase();
    let starts: Vec<usize> = text.match_indices(|c: char| c.is_ascii_alphabetic()).map(|(at, _)| at).collect();
    if !text.is_ascii() || !text.is_empty() && starts.first() != Some(&0) {
        return None;
    }
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    starts.iter().zip(ends).map(|(&at, end)| {
        Some((text.as_bytes()[at] as char, decimal(&text[at + 1..end])?))
    }).collect()
}

fn alarm(class: &str, b: usize) -> ! {
    println!(r#"{{"k":"alarm","class":"{class}","b":{b}}}"#);
    exit(1)
}

/// Executes one line; true at the end of the program.
fn block(words: &[(char, String)], b: usize, motion: &mut Option<&'static str>, feed: &mut String) -> bool {
    let (mut to, mut names_motion, mut ends) = (Vec::new(), false, false);
    for (at, (letter, number)) in words.iter().enumerate() {
        if words[..at].iter().any(|(before, _)| before == letter) {
            exit(3)
        }
        match (letter, number.as_str()) {
            ('G', "0") | ('G', "1") => {
                *motion = Some(if number == "0" { "rapid" } else { "feed" });
                names_motion = true;
            }
            ('X' | 'Y' | 'Z', _) => to.push(format!(r#""{}":"{number}""#, letter.to_ascii_lowercase())),
            ('F', _) if !number.starts_with('-') => *feed = number.clone(),
            ('M', "2") => ends = true,
            _ => exit(3),
        }
    }
    if !to.is_empty() || names_motion {
        let has_feed = feed.bytes().any(|byte| (b'1'..=b'9').contains(&byte));
        match *motion {
            None => alarm("missing-word", b),
            Some("feed") if !has_feed => alarm("feed-missing", b),
            Some(kind) if !to.is_empty() => {
                let speed = if kind == "feed" { format!(r#","f":"{feed}""#) } else { String::new() };
                println!(r#"{{"k":"{kind}","b":{b},"to":{{{}}}{speed}}}"#, to.join(","));
            }
            Some(_) => {}
        }
    }
    if ends {
        println!(r#"{{"k":"m","b":{b},"m":2}}"#);
    }
    ends
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let profile = arguments.iter().position(|word| word == "--profile").and_then(|at| arguments.get(at + 1));
    if profile.map_or(true, |file| std::fs::read_to_string(file).map_or(true, |text| text.trim() != "{}")) {
        exit(3)
    }
    let mut bytes = Vec::new();
    std::io::stdin().read_to_end(&mut bytes).expect("the program comes on standard input");
    let program = String::from_utf8(bytes).unwrap_or_else(|_| exit(3));
    let program = program.replace("\r\n", "\n").replace('\r', "\n");
    let (mut motion, mut feed) = (None, String::new());
    let lines: Vec<&str> = program.strip_suffix('\n').unwrap_or(&program).split('\n').collect();
    for (at, line) in lines.iter().enumerate() {
        let words = words_of(line).unwrap_or_else(|| exit(3));
        if block(&words, at + 1, &mut motion, &mut feed) {
            return;
        }
    }
    alarm("program-end", lines.len())
}
