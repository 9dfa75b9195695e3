//! Bad input from end to end: status 2, and a message with place, value, bound and next step.

mod common;

use common::{Ended, Folder, LOADED, edit};

/// Runs the loaded study after one edit; nothing may be written but the complaint.
fn refused(test: &str, old: &str, new: &str) -> Ended {
    let folder = Folder::with_study(test, &edit(LOADED, old, new));
    let ended = folder.signorini("run loaded").expect(2);
    assert!(ended.err.starts_with("error: ") && ended.err.contains("\nhint: "), "{}", ended.err);
    assert_eq!(ended.out, "");
    assert!(!folder.path("reports/loaded").exists());
    ended
}

/// Where the edited words stand, as `loaded.toml:line:column`, with a caret below them.
fn refused_at(test: &str, old: &str, new: &str, culprit: &str, words: &[&str]) {
    let text = edit(LOADED, old, new);
    let before = &text[..text.find(culprit).expect("the culprit stands in the study")];
    let line = before.lines().count().max(1) + usize::from(before.ends_with('\n'));
    let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
    let ended = refused(test, old, new).complains(2, words).complains(2, &[&format!("loaded.toml:{line}:{column}: ")]);
    let lines: Vec<&str> = ended.err.lines().collect();
    let caret = lines.iter().position(|l| l.trim_start_matches([' ', '|']).starts_with('^')).expect("a caret");
    let below = |line: &str| {
        line.chars().skip(lines[caret].chars().position(|c| c == '^').expect("a caret")).collect::<String>()
    };
    let shown = below(lines[caret - 1]);
    assert!(shown.starts_with(culprit.lines().next().expect("a line")), "{}", ended.err);
}

const LOWER: &str = "poisson = 0.3, plane = \"strain\" }\nrectangle = [[0, -1], [1, 0]]";
const LOAD: &str = "\"-0.1*(1 - 1.75*x)\"";

#[test]
fn malformed_toml() {
    refused_at("toml", "claim = \"two-squares\"", "claim = two-squares", "two-squares", &["hint: "]);
    refused_at("key", "[contact]", "[contakt]", "contakt", &["unknown field `contakt`", "did you mean `contact`?"]);
}

#[test]
fn a_boundary_part_of_no_body() {
    let words = ["there is no body `lowr`", "did you mean `lower`?"];
    refused_at("body", "\"lower\"\nname = \"bottom\"", "\"lowr\"\nname = \"bottom\"", "\"lowr\"", &words);
}

#[test]
fn contact_nodes_without_partners() {
    let divided = format!("{LOWER}\ndivisions = [2, 1]");
    let words = ["loaded.toml", "Ω'' at (0.125, 0) has no partner", "1.250e-1 away", "at most", "the same divisions"];
    refused("partners", LOWER, &divided).complains(2, &words);
}

#[test]
fn a_clockwise_block() {
    let block =
        LOWER.replace("rectangle = [[0, -1], [1, 0]]", "blocks = [{ corners = [[0, -1], [0, 0], [1, 0], [1, -1]] }]");
    refused_at("clockwise", LOWER, &block, "[[0, -1], [0, 0], [1, 0], [1, -1]]", &["= -1 ≤ 0", "counterclockwise"]);
}

#[test]
fn an_incompressible_material() {
    for (test, ratio) in [("half", "0.5"), ("beyond", "0.62")] {
        let words = [&format!("ν = {ratio} must satisfy −1 < ν < 1/2"), "hint: choose E > 0"];
        refused_at(test, LOWER, &LOWER.replace("0.3", ratio), &format!("{ratio}, plane"), &words);
    }
}

#[test]
fn elastic_constants_that_are_not_positive() {
    let law = "{ matrix = [[1, 3, 0], [3, 1, 0], [0, 0, 1]] }";
    let old = "name = \"lower\"\nmaterial = { young = 1.0, poisson = 0.3, plane = \"strain\" }";
    let words = ["smallest modulus c0 = -2.000e0 must be positive", "(2.7)"];
    refused_at("positive", old, &format!("name = \"lower\"\nmaterial = {law}"), law, &words);
}

#[test]
fn a_load_that_pushes_a_free_body_away() {
    let words = ["loaded.toml", "translation of Ω' along (0, 1)", "resultant 1.000000e-1 > 0", "support the body"];
    refused("away", LOAD, "\"0.1\"").complains(2, &words);
}

#[test]
fn a_limit_load() {
    refused("limit", LOAD, "\"0\"").complains(2, &["limit load", "translation of Ω' along (0, 1)"]);
    // Pressed and pulled with the same resultant.
    let balanced = refused("balance", LOAD, "\"x - 0.5\"");
    balanced.complains(2, &["translation of Ω' along (0, 1)", "limit load"]);
}

#[test]
fn a_load_along_a_free_slide() {
    let text = edit(LOADED, "condition = \"sliding\"", "condition = \"free\"");
    let folder = Folder::with_study("slide", &edit(&text, "value = [\"0\",", "value = [\"0.05\","));
    let words = ["no equilibrium", "translation of Ω' along (1, 0)", "5.000000e-2", "must vanish within"];
    folder.signorini("run loaded").complains(2, &words);
}

#[test]
fn no_contact_zone() {
    refused_at(
        "zone",
        "[contact]\nalong = [[0, 0], [1, 0]]\n",
        "",
        "\"loaded\"",
        &["no [contact]", "hint: add [contact]"],
    );
}

#[test]
fn an_expression_that_cannot_be_read() {
    refused_at("open", LOAD, "\"-0.1*(1 - 1.75*x\"", "(1 - 1.75*x\"", &["is never closed", "x, y, nx, ny"]);
    refused_at("function", LOAD, "\"-0.1*coss(x)\"", "coss(x)", &["unknown function `coss`", "did you mean `cos`?"]);
}

#[test]
fn a_load_that_is_no_number_somewhere() {
    let words = ["loaded.toml", "traction on part 'top' near (0.", "(0, NaN)", "check its expression there"];
    refused("load", LOAD, "\"-0.1*sqrt(0.6 - x)\"").complains(2, &words);
    let bottom = "along = [[0, -1], [1, -1]]\ncondition = \"fixed\"";
    let words = ["prescribed displacement at (", ", -1) is (0, NaN)", "check its expression there"];
    refused("data", bottom, &format!("{bottom}\nvalue = [\"0\", \"log(x)*0/0\"]")).complains(2, &words);
}

#[test]
fn one_bad_case_among_good_ones_is_named() {
    let cases = "\n[[case]]\nname = \"good\"\n\n[[case]]\nname = \"bad\"\n\n[[case.body]]\nname = \"upper\"\n\
        material = { lame = [1, 1] }\nrectangle = [[0, 0], [1, 1]]\n\n[[case.body]]\nname = \"lower\"\n\
        material = { lame = [1, 1] }\nrectangle = [[0, -1], [1, 0]]\ndivisions = [3, 1]\n";
    let folder = Folder::with_study("case", &(LOADED.to_owned() + cases));
    for command in ["run", "check"] {
        folder.signorini(&format!("{command} loaded")).complains(2, &["loaded.toml", "case 'bad'", "has no partner"]);
    }
}

#[test]
fn an_output_folder_that_is_a_file() {
    let folder = Folder::with_study("out", LOADED);
    folder.write("taken", "a file");
    let ended = folder.signorini("run loaded --out taken").complains(2, &["error: ", "taken", "hint: ", "--out"]);
    assert!(!ended.err.contains("panicked"), "{}", ended.err);
    assert_eq!(folder.text("taken"), "a file");
    // The folder is there, but a file stands where the study's folder belongs.
    folder.write("reports/loaded", "a file");
    folder.signorini("run loaded").complains(2, &["reports/loaded", "--out"]);
}
