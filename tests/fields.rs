//! Fields of levels: what `--fields` writes, what `report` draws again from it, and what it refuses.

mod common;

use common::{Folder, SMOOTH, names, same_tree, tree};

/// The files of `reports/smooth` that belong to fields or are drawn from them.
fn of_fields(folder: &Folder) -> Vec<String> {
    let ours = |name: &String| ["fields/", "mesh.", "deformed."].iter().any(|start| name.starts_with(start));
    names(&folder.path("reports/smooth")).into_iter().filter(ours).collect()
}

#[test]
fn levels_that_are_asked_for_are_written_drawn_and_drawn_again_without_solving() {
    let folder = Folder::with_study("asked", SMOOTH);
    folder.signorini("run --levels 2 --fields 1,7").complains(2, &["smooth: no level 7", "0 to 1"]);
    let written = of_fields(&folder);
    for file in [
        "deformed.svg",
        "fields/level-1-deformed.png",
        "fields/level-1-mesh.svg",
        "fields/level-1-pressure.png",
        "fields/level-1-zone.vtu",
        "fields/level-1.json",
        "fields/level-1.vtu",
        "fields/level-1/stress.npy",
        "mesh.png",
    ] {
        assert!(written.iter().any(|name| name == file), "no {file} in {written:?}");
    }
    let before = tree(&folder.path("reports"), "timings.json");
    for picture in ["mesh.svg", "deformed.png", "fields/level-1-pressure.svg"] {
        std::fs::remove_file(folder.path("reports/smooth").join(picture)).expect("a picture");
    }
    folder.signorini("report reports").expect(2);
    same_tree(&before, &tree(&folder.path("reports"), "timings.json"));
}

#[test]
fn without_levels_one_is_kept_for_the_page_and_none_leaves_nothing() {
    let folder = Folder::with_study("page", SMOOTH);
    folder.signorini("run --levels 1");
    let of_page =
        ["deformed.png", "deformed.svg", "fields/level-0-zone.vtu", "fields/level-0.json", "fields/level-0.vtu"];
    assert_eq!(of_fields(&folder), [of_page.as_slice(), &["mesh.png", "mesh.svg"]].concat());
    folder.signorini("run --levels 1 --fields none");
    assert_eq!(of_fields(&folder), [""; 0], "what an earlier run left belongs to another record");
}

#[test]
fn words_that_name_no_level_and_files_that_hold_no_fields_are_refused() {
    let folder = Folder::with_study("refused", SMOOTH);
    folder.signorini("run --fields finest").complains(2, &["`finest`", "none, all, last", "--fields 0,3"]);
    folder.signorini("run --levels 1");
    let path = folder.path("reports/smooth/fields/level-0.json");
    let text = std::fs::read_to_string(&path).expect("fields");
    std::fs::write(&path, text.replacen("\"first_triangles\":", "\"first\":", 1)).expect("fields");
    folder.signorini("report reports").complains(2, &["level-0.json", "first_triangles", "hint: "]);
}
