//! The studies that are built into the program, so that it works without a checkout.

use super::library::Group;

macro_rules! shipped {
    ($($group:ident $folder:literal: $($id:literal)*;)*) => {
        /// Group, id and text, in the order in which they are listed.
        pub(super) const SHIPPED: &[(Group, &str, &str)] = &[
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
        "corner-patch"
        "hertz"
        "lemma-2-1"
        "lemma-3-2"
        "lemma-3-3-full"
        "lemma-3-3"
        "lemma-3-4"
        "many-switches"
        "pin-in-hole"
        "remark-3-2a"
        "remark-3-2b"
        "remark-3-4"
        "theorem-3-1-natural"
        "theorem-3-1-smooth"
        "theorem-3-3"
        "theorem-3-4"
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
        "fixed-quadrature"
        "hertz-plane-stress"
        "loose-solver"
        "roaming-switch"
        "same-mesh-twice"
        "skewed-parameter"
        "too-few-levels"
        "wrong-mu"
    ;
}
