//! Malformed studies: each is one edit away from a good one, and each error names its place.

use crate::study::{ReferencePlan, Study};
use std::path::Path;

/// A small good study; every malformed one replaces one piece of it.
pub const GOOD: &str = r#"id = "small"
title = "t"
question = "q"
setup = "s"
refuted_by = "r"
claim = "theorem-3-1"

[[body]]
name = "upper"
material = { young = 1.0, poisson = 0.3 }
rectangle = [[0, 0], [1, 1]]
force = ["0", "sin(x)"]

[[body]]
name = "lower"
material = { matrix = [[3, 1, 0], [1, 3, 0], [0, 0, 1]] }
blocks = [{ corners = [[0, -1], [1, -1], [1, 0], [0, 0]], divisions = [1, 1] }]

[[boundary]]
body = "lower"
name = "bottom"
along = [[0, -1], [1, -1]]
condition = "fixed"

[[boundary]]
body = "upper"
name = "top"
along = [[0, 1], [1, 1]]
condition = "traction"
value = ["0", "-0.1*nx"]

[contact]
along = [[0, 0], [1, 0]]

[levels]
quick = [8, 16, 32, 64]

[[case]]
name = "one"

[[case]]
name = "two"
family = { name = "refined", seed = 1, amount = 0.2 }
"#;

/// What is replaced, by what, and where and how the reader complains: the place of the given words in the new text.
type Row = (&'static str, &'static str, &'static str, &'static str);

#[rustfmt::skip]
const TABLE: &[Row] = &[
    // second opinions, initial gaps
    ("[levels]", "[solver]\nsecond = \"condensed\"\n\n[levels]", "\"condensed\"", "would agree with itself"),
    ("[levels]", "[solver]\nsecond = \"simplex\"\n\n[levels]", "\"simplex\"", "unknown variant"),
    ("[contact]\n", "[contact]\ninitial_gap = \"z\"\n", "z\"\nalong", "expression `z`"),
    // TOML itself
    ("id = \"small\"", "id = small\"", "small", "missing opening quote"),
    ("[contact]\n", "[contact\n", "\nalong = [[0, 0], [1, 0]]", "unclosed table"),
    ("title = \"t\"", "title = \"t\"\ntitle = \"u\"", "title = \"u\"", "duplicate key"),
    // keys
    ("[levels]", "[levls]", "levls]", "unknown field `levls`"),
    ("poisson = 0.3", "poison = 0.3", "poison", "unknown field `poison`"),
    ("condition = \"fixed\"", "condition = \"fixt\"", "\"fixt\"", "unknown variant `fixt`"),
    ("title = \"t\"\n", "", "", "missing field `title`"),
    // types and values
    ("title = \"t\"", "title = 3", "3", "invalid type: integer `3`, expected a string"),
    ("young = 1.0", "young = \"stiff\"", "\"stiff\"", "expected a number"),
    ("young = 1.0", "young = nan", "nan", "NaN is not a finite number"),
    ("[[0, 0], [1, 1]]", "[[0, 0], [inf, 1]]", "inf", "inf is not a finite number"),
    ("quick = [8, 16, 32, 64]", "quick = [-8, 16]", "-8", "expected a whole number, zero or positive"),
    ("divisions = [1, 1]", "divisions = [1, 1, 1]", "[1, 1, 1]", "invalid length 3, expected 2 entries"),
    ("seed = 1", "seed = 1.5", "1.5", "expected a whole number, zero or positive"),
    ("[[0, 0], [1, 1]]", "[[0, 0, 5], [1, 1]]", "[0, 0, 5]", "invalid length 3, expected 2 entries"),
    ("[\"0\", \"sin(x)\"]", "[\"sin(x)\"]", "[\"sin(x)\"]", "invalid length 1, expected 2 entries"),
    // names
    ("body = \"lower\"", "body = \"lowr\"", "\"lowr\"", "there is no body `lowr`"),
    ("name = \"two\"", "name = \"one\"", "\"one\"\nfamily", "two cases named `one`"),
    ("name = \"two\"", "name = \"../two\"", "\"../two\"", "cannot name a folder"),
    ("name = \"lower\"\nmaterial", "name = \"upper\"\nmaterial", "\"upper\"\nmaterial = { matrix", "two bodies named `upper`"),
    ("body = \"upper\"\nname = \"top\"\nalong = [[0, 1], [1, 1]]", "body = \"lower\"\nname = \"bottom\"\nalong = [[0, -1], [0, 0]]",
        "\"bottom\"\nalong = [[0, -1], [0", "two boundary parts `bottom`"),
    ("id = \"small\"", "id = \"tall\"", "\"tall\"", "id `tall` in a file named"),
    ("claim = \"theorem-3-1\"", "claim = \"theorem-3-1a\"", "\"theorem-3-1a\"", "no claim `theorem-3-1a`"),
    ("claim = \"theorem-3-1\"", "claim = \"remark-1-2\"", "\"remark-1-2\"", "has nothing to run"),
    ("claim = \"theorem-3-1\"\n", "", "\"small\"", "claims nothing"),
    ("[levels]", "[exact]\nbuiltin = \"Q\"\n[levels]", "\"Q\"", "no built-in exact solution `Q`"),
    ("[levels]", "[exact]\nbuiltin = \"R\"\n[levels]", "\"R\"", "isotropic bodies only"),
    ("name = \"refined\"", "name = \"refind\"", "\"refind\"", "unknown variant `refind`"),
    // corners and projections
    ("[levels]", "[expected]\nrate = \"corner\"\n[levels]", "\"corner\"", "expected a number, \"none\" or \"corners\""),
    ("[levels]", "[reference]\nkind = \"none\"\nproject = true\n[levels]", "true\n[levels]", "neither exact nor nested"),
    // materials
    ("poisson = 0.3", "poisson = 0.5", "0.5", "ν = 0.5 must satisfy −1 < ν < 1/2"),
    ("young = 1.0", "young = -2", "-2", "E = -2 must be positive"),
    ("[[3, 1, 0], [1, 3, 0], [0, 0, 1]]", "[[1, 3, 0], [3, 1, 0], [0, 0, 1]]", "{ matrix", "not positive"),
    ("[[3, 1, 0], [1, 3, 0], [0, 0, 1]]", "[[3, 1, 0], [2, 3, 0], [0, 0, 1]]", "{ matrix", "not symmetric"),
    ("{ young = 1.0, poisson = 0.3 }", "{ young = 1.0, poisson = 0.3, lame = [1, 1] }", "{ young", "2 laws where there must be 1"),
    ("{ young = 1.0, poisson = 0.3 }", "{ young = 1.0 }", "{ young", "belong together"),
    ("{ young = 1.0, poisson = 0.3 }", "{ lame = [1, 1], plane = \"stress\" }", "\"stress\"", "`plane` says nothing here"),
    ("{ young = 1.0, poisson = 0.3 }",
        "{ orthotropic = { moduli = [1, 1, 1], ratios = [2, 2, 2], shear = 1 } }", "{ orthotropic", "not positive"),
    // geometry
    ("[[0, 0], [1, 1]]", "[[0, 0], [0, 1]]", "[[0, 0], [0, 1]]\nforce", "has no area"),
    ("[[0, -1], [1, -1], [1, 0], [0, 0]]", "[[0, -1], [0, 0], [1, 0], [1, -1]]", "[[0, -1], [0, 0]", "no left turn"),
    ("divisions = [1, 1]", "divisions = [0, 1]", "[0, 1]", "must lie between 1 and 1024"),
    ("[contact]\nalong = [[0, 0], [1, 0]]\n", "", "\"one\"", "no [contact]"),
    ("[contact]\nalong = [[0, 0], [1, 0]]", "[contact]\nalong = [[0, 0]]", "[[0, 0]]\n", "a polyline of 1 point(s)"),
    ("[contact]\nalong = [[0, 0], [1, 0]]", "[contact]\nalong = [[0, 0], [0, 0]]", "[[0, 0], [0, 0]]", "twice in a row"),
    ("[contact]\nalong = [[0, 0], [1, 0]]", "[contact]\nalong = [[0, 0], [1, 0.1]]", "[[0, 0], [1, 0.1]]",
        "(1, 0.1) lies on no side of body `lower`"),
    ("[[body]]\nname = \"lower\"\nmaterial = { matrix = [[3, 1, 0], [1, 3, 0], [0, 0, 1]] }\n\
        blocks = [{ corners = [[0, -1], [1, -1], [1, 0], [0, 0]], divisions = [1, 1] }]\n", "", "\"one\"", "1 bodies"),
    // expressions
    ("\"sin(x)\"", "\"sin(x\"", "(x\"]", "expression `sin(x`"),
    ("\"sin(x)\"", "\"2*sinn(x)\"", "sinn", "sinn"),
    ("\"sin(x)\"", "\"nx\"", "nx", "nx"),
    ("\"-0.1*nx\"", "\"-0.1*k\"", "k\"", "k"),
    ("condition = \"fixed\"", "condition = \"fixed\"\nvalue = [\"0\", \"ny\"]", "ny\"]\n", "ny"),
    ("condition = \"fixed\"", "condition = \"sliding\"\nvalue = [\"0\", \"0\"]", "[\"0\", \"0\"]", "`value` on boundary `bottom`"),
    // how it is computed and judged
    ("quick = [8, 16, 32, 64]", "quick = []", "[]", "no levels"),
    ("quick = [8, 16, 32, 64]", "quick = [8, 16, 16, 64]", "[8, 16, 16", "level 16 does not refine level 16"),
    ("quick = [8, 16, 32, 64]", "quick = [8, 12, 32, 64]", "[8, 12", "does not arise from 12 cells"),
    ("[levels]", "[reference]\nkind = \"none\"\n[levels]\nfull = [8, 24]", "[8, 24]", "never has 24"),
    ("quick = [8, 16, 32, 64]", "quick = [8, 99999]", "[8, 99999", "99999 cells"),
    ("amount = 0.2", "amount = 0.5", "0.5", "amount = 0.5 must lie between 0 and 0.5"),
    ("amount = 0.2 }", "}", "{ name = \"refined\"", "needs `seed` and `amount`"),
    ("name = \"refined\"", "name = \"structured\"", "1, amount", "says nothing about this family"),
    ("[levels]", "[reference]\nkind = \"exact\"\n[levels]", "[reference]", "the scene has no exact solution"),
    ("[levels]", "[solver]\ntolerance = 0\n[levels]", "0\n[levels]", "tolerance = 0 must lie between 0 and 1"),
    ("[levels]", "[solver]\naccuracy = 1.0\n[levels]", "1.0\n[levels]", "is no share of the discretisation error"),
    ("[levels]", "[gates]\nfall = 0.8\n[levels]", "[gates]", "gives no `reason`"),
    ("[levels]", "[gates]\nspread = 0.8\nreason = \"r\"\n[levels]", "0.8", "spread = 0.8 must exceed 1"),
    ("[levels]", "[gates]\nfixed_quadrature = true\nreason = \"r\"\n[levels]", "true", "is a planted defect"),
    ("[levels]", "[expected]\npaper = \"nine\"\n[levels]", "\"nine\"", "expected a number or \"none\""),
    ("[levels]", "[expected]\nasymptotic_only = true\n[levels]", "[expected]", "needs a `reason`"),
];

#[test]
fn the_text_they_start_from_is_good() {
    let study = Study::parse(GOOD, Path::new("small.toml")).unwrap();
    assert_eq!(study.cases.iter().map(|c| c.name.as_str()).collect::<Vec<_>>(), ["one", "two"]);
}

#[test]
fn every_error_names_its_place_and_a_next_step() {
    let wrong: Vec<String> = TABLE.iter().filter_map(|row| checked(row).err()).collect();
    assert!(wrong.is_empty(), "{} of {}:\n\n{}", wrong.len(), TABLE.len(), wrong.join("\n\n"));
}

fn checked((old, new, place, complaint): &Row) -> Result<(), String> {
    assert_eq!(GOOD.matches(old).count(), 1, "{old:?} must stand once in the good text");
    let text = GOOD.replacen(old, new, 1);
    let e = Study::parse(&text, Path::new("small.toml")).err().ok_or(format!("accepted: {new:?}"))?;
    let at = text.find(place).ok_or(format!("{place:?} is not in the text with {new:?}"))?;
    let before = &text[..at];
    let expected = (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1);
    let seen = e.position.as_ref().map(|p| (p.line, p.column));
    let good = e.message.contains(complaint) && seen == Some(expected) && !e.next.is_empty();
    if good { Ok(()) } else { Err(format!("{new:?} should complain of {complaint:?} at {expected:?}:\n{e}")) }
}

/// Where no mesh refines another, a reference needs to be finer and no more.
#[test]
fn a_reference_of_a_family_that_is_not_nested_is_finer_than_its_levels() {
    let alone = GOOD.replacen("[[case]]\nname = \"one\"\n", "", 1);
    let perturbed = alone.replacen("name = \"refined\"", "name = \"perturbed\"", 1);
    let with = |quick: &str| Study::parse(&perturbed.replacen("[8, 16, 32, 64]", quick, 1), Path::new("small.toml"));
    let study = with("[8, 12, 100]").unwrap();
    let perturbed = &study.cases[0];
    assert_eq!((perturbed.family_name(), &perturbed.quick[..]), ("perturbed", &[8, 12, 100][..]));
    assert_eq!(perturbed.reference, ReferencePlan::Overkill { quick: 256, full: 1024 });
    assert!(perturbed.notes.iter().any(|n| n.contains("by point location")), "{:?}", perturbed.notes);
    let e = with("[8, 16, 256]").err().unwrap();
    assert!(e.message.contains("256 cells is no finer than the level of 256"), "{e}");
}

#[test]
fn slips_of_the_keyboard_are_recognised() {
    let rows = [
        ("[levels]", "[levls]", "did you mean `levels`?"),
        ("body = \"lower\"", "body = \"lowr\"", "did you mean `lower`?"),
        ("condition = \"fixed\"", "condition = \"fxied\"", "did you mean `fixed`?"),
        ("claim = \"theorem-3-1\"", "claim = \"theorem-31\"", "did you mean `theorem-3-1`?"),
    ];
    for (old, new, hint) in rows {
        let e = Study::parse(&GOOD.replacen(old, new, 1), Path::new("small.toml")).err().unwrap();
        assert_eq!(e.next, hint);
    }
}

#[test]
fn the_caret_stands_under_the_culprit() {
    let text = GOOD.replacen("\"sin(x)\"", "\"µ + sin(x)\"", 1);
    let shown = Study::parse(&text, Path::new("small.toml")).err().unwrap().to_string();
    let lines: Vec<&str> = shown.lines().collect();
    let column = |line: &str, c: char| line.chars().position(|x| x == c);
    assert!(lines[2].contains("force = "), "{shown}");
    assert_eq!(column(lines[2], 'µ'), column(lines[3], '^'), "{shown}");
}

#[test]
fn a_missing_file_is_an_error_without_a_place() {
    let e = Study::load(Path::new("no/such/study.toml")).err().unwrap();
    assert!(e.position.is_none() && e.to_string().starts_with("no/such/study.toml: cannot read"), "{e}");
}
