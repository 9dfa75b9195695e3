//! The studies that are built into the program, so that it works without a checkout.

use super::library::Group;

macro_rules! shipped {
    ($($group:ident $folder:literal: $($id:literal)*;)*) => {
        /// Group, id and text, in the order in which they are listed.
        pub(crate) const SHIPPED: &[(Group, &str, &str)] = &[
            $($((
                Group::$group,
                $id,
                include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/", $folder, $id, ".toml")),
            ),)*)*
        ];
    };
}

shipped! {
    Standard "":
        "bent-angles"
        "bent-arc"
        "bent-graph"
        "bent-pressure"
        "bent-regularity"
        "bent-strong-regularity"
        "contact-sets"
        "corner-patch"
        "dovetail"
        "hertz"
        "lemma-1-1"
        "lemma-2-1"
        "lemma-3-1"
        "lemma-3-2"
        "lemma-3-3-full"
        "lemma-3-3"
        "lemma-3-4"
        "lemma-3-5"
        "lemma-3-6"
        "many-switches"
        "pin-imported"
        "pin-in-hole"
        "remark-1-1"
        "remark-1-3"
        "remark-1-6"
        "remark-3-1"
        "remark-3-2a"
        "remark-3-2b"
        "remark-3-3"
        "remark-3-4"
        "remark-3-5"
        "remark-3-6"
        "remark-3-7"
        "theorem-1-2"
        "theorem-3-1-natural"
        "theorem-3-1-smooth"
        "theorem-3-2"
        "theorem-3-3"
        "theorem-3-4"
        "theorem-3-5"
        "two-squares"
    ;
    Hard "hard/":
        "hard-angles"
        "hard-balance"
        "hard-contrast"
        "hard-gaps"
        "hard-grazing"
        "hard-groove"
        "hard-incompressible"
        "hard-million"
        "hard-slender"
        "hard-smallest"
        "hard-switches"
        "hard-units"
        "hard-whisper"
    ;
    Controls "controls/":
        "averaged-normals"
        "chord-normals"
        "chords"
        "degenerate"
        "fixed-quadrature"
        "hertz-plane-stress"
        "loose-solver"
        "nodes-hold-less"
        "outside-k"
        "roaming-switch"
        "same-mesh-twice"
        "skewed-parameter"
        "slide-without-p"
        "too-few-levels"
        "wrong-mu"
    ;
}

macro_rules! meshes {
    ($($path:literal)*) => {
        /// The mesh files that shipped studies name, by their path from `studies/`.
        pub(super) const MESHES: &[(&str, &[u8])] =
            &[$(($path, include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/", $path))),)*];
    };
}

meshes! {
    "meshes/dovetail.msh"
    "meshes/pin.msh"
}
