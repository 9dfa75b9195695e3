//! Fields of solved levels against the numbers of their record, and their files against what they hold.

use super::packed::{self, Packed};
use super::store::{read_fields, write_fields};
use super::{ContactStatus, Fields, Keep, npy, page_level, vtu};
use crate::record::StudyRecord;
use crate::run::{Profile, RunSettings, Unwatched, run_case};
use crate::sample;
use crate::store::scratch::Scratch;
use signorini_contact::material::contract;

fn run(study: &str, case: &str, levels: usize, keep: Keep) -> (StudyRecord, Vec<Fields>) {
    let study = sample::study(study);
    let case = study.cases.iter().find(|c| c.name == case).unwrap();
    let settings = RunSettings { profile: Profile::Quick, levels: Some(levels), solver: None, partial: None, keep };
    let run = run_case(&study, case, &settings, &Unwatched).unwrap();
    (run.record, run.fields)
}

/// Relative differences from the record: of `Σ |T| τ:ε` from `A(u_h, u_h)`, of the pressure's integral from the force, of the largest
/// pressure.
fn differences(record: &StudyRecord, fields: &Fields) -> [f64; 3] {
    let level = &record.levels[fields.level];
    let contact = level.contact.as_ref().unwrap();
    let triangles = 0..fields.areas.len();
    let energy: f64 = triangles.map(|t| fields.areas[t] * contract(fields.stress[t], fields.strain[t])).sum();
    let zone = &fields.zone;
    let side = |ends: &[u32; 2]| {
        let [a, b] = ends.map(|i| i as usize);
        0.5 * (zone.s[b] - zone.s[a]) * (zone.pressure[a] + zone.pressure[b])
    };
    let force: f64 = zone.sides.iter().map(side).sum();
    let peak = zone.pressure.iter().copied().fold(0.0, f64::max);
    [energy / level.solution_energy.unwrap().powi(2), force / contact.force, peak / contact.peak_pressure]
        .map(|ratio| (ratio - 1.0).abs())
}

#[test]
fn energy_force_and_peak_pressure_are_those_of_the_record() {
    for (study, case) in [("theorem-3-1-natural", "structured"), ("theorem-3-3", "structured")] {
        let (record, fields) = run(study, case, 2, Keep::All);
        assert_eq!(fields.iter().map(|f| f.level).collect::<Vec<_>>(), [0, 1]);
        for f in &fields {
            assert!(differences(&record, f).iter().all(|d| *d < 1e-11), "{study}: {:?}", differences(&record, f));
            let touching = f.zone.status.iter().filter(|s| **s == ContactStatus::Contact as u8).count();
            assert_eq!((touching, f.check()), (record.levels[f.level].active, Ok(())));
        }
        assert!(!record.to_json().unwrap().contains("fields"), "fields are no part of a record");
    }
}

#[test]
fn stresses_and_pressures_of_elsewhere_are_told_apart() {
    let (record, mut fields) = run("theorem-3-1-natural", "structured", 1, Keep::All);
    fields[0].stress.reverse();
    fields[0].zone.pressure.iter_mut().for_each(|p| *p *= 1.0 + 1e-9);
    assert!(differences(&record, &fields[0]).iter().all(|d| *d > 1e-10));
}

/// On isoparametric triangles strains vary, and the centroid stands for all of it.
#[test]
fn across_a_gap_the_centroid_gives_the_energy_nearly() {
    let (record, fields) = run("theorem-3-4", "convex-structured", 2, Keep::Last);
    let [energy, force, peak] = differences(&record, &fields[0]);
    assert!(energy < 1e-3 && force < 1e-11 && peak < 1e-14, "{energy} {force} {peak}");
    assert!(fields[0].zone.across_gap && fields[0].level == 1 && !fields[0].arcs.is_empty());
}

/// An outline follows the circle, and so do the areas: the polygon about a curved triangle has nearly its area.
#[test]
fn outlines_follow_the_curve() {
    let (_, fields) = run("theorem-3-3", "structured", 1, Keep::Page);
    let f = &fields[0];
    for arc in &f.arcs {
        let outline = f.outline(arc.triangle as usize, 0.0);
        let next = outline.iter().cycle().skip(1);
        let area: f64 = outline.iter().zip(next).map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0])).sum();
        let chord: f64 = {
            let [a, b, c] = f.triangles[arc.triangle as usize].map(|i| f.nodes[i as usize]);
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        };
        let exact = f.areas[arc.triangle as usize];
        // eight chords miss a 64th of what one misses
        assert!((area - exact).abs() < 0.02 * (chord - exact).abs(), "{area} {chord} {exact}");
    }
}

#[test]
fn the_page_shows_the_finest_level_that_can_be_drawn() {
    let (_, page) = run("theorem-3-1-natural", "structured", 3, Keep::Page);
    assert_eq!(page.iter().map(|f| (f.level, f.asked)).collect::<Vec<_>>(), [(1, false)]);
    let (_, two) = run("theorem-3-1-natural", "structured", 3, Keep::Levels(vec![0, 2, 9]));
    assert_eq!(two.iter().map(|f| (f.level, f.asked)).collect::<Vec<_>>(), [(0, true), (2, true)]);
    assert_eq!((page_level(&two), page_level(&two[1..]), page_level(&[])), (Some(0), Some(0), None));
    assert!(run("theorem-3-1-natural", "structured", 1, Keep::None).1.is_empty());
}

#[test]
fn fields_come_back_bit_for_bit_and_those_of_an_earlier_run_go() {
    let scratch = Scratch::new("fields");
    let (_, fields) = run("theorem-3-3", "structured", 2, Keep::All);
    let written = write_fields(&scratch.0, &fields).unwrap();
    assert!(written.iter().all(|path| path.is_file()));
    assert!(scratch.0.join("fields/level-1/von_mises.npy").is_file());
    assert_eq!(read_fields(&scratch.0).unwrap(), fields);
    let own = scratch.0.join("fields/notes.txt");
    std::fs::write(&own, "mine").unwrap();
    write_fields(&scratch.0, &fields[..1]).unwrap();
    assert_eq!(read_fields(&scratch.0).unwrap(), fields[..1]);
    assert!(own.is_file() && !scratch.0.join("fields/level-1").exists());
    write_fields(&scratch.0, &[]).unwrap();
    assert_eq!(read_fields(&scratch.0).unwrap(), []);
}

#[test]
fn fields_that_do_not_fit_together_are_named() {
    let scratch = Scratch::new("broken-fields");
    let (_, fields) = run("theorem-3-1-natural", "structured", 1, Keep::All);
    let broken = |change: &dyn Fn(&mut Fields)| {
        let mut copy = fields[0].clone();
        change(&mut copy);
        write_fields(&scratch.0, &[copy]).unwrap();
        read_fields(&scratch.0).unwrap_err().to_string()
    };
    let node = broken(&|f| f.triangles[3][1] = 9999);
    assert!(node.contains("level-0.json") && node.contains("triangles names a row"), "{node}");
    let short = broken(&|f| f.von_mises.truncate(f.von_mises.len() - 1));
    assert!(short.contains("von_mises has") && short.contains("must have"), "{short}");
    let number = broken(&|f| f.stress[0][1] = f64::NAN);
    assert!(number.contains("NaN"), "{number}");
}

/// Header and numbers as NumPy's format describes them.
#[test]
fn numpy_files_have_their_shape_and_numbers() {
    let (_, fields) = run("theorem-3-1-natural", "structured", 1, Keep::All);
    let files = npy::files(&fields[0]);
    let (_, stress) = files.iter().find(|(name, _)| name == "stress.npy").unwrap();
    let length = usize::from(u16::from_le_bytes([stress[8], stress[9]]));
    let header = std::str::from_utf8(&stress[10..10 + length]).unwrap();
    assert_eq!((&stress[..8], (10 + length) % 64), (b"\x93NUMPY\x01\x00".as_slice(), 0));
    let shape = format!("'fortran_order': False, 'shape': ({}, 3), }}", fields[0].stress.len());
    assert!(header.starts_with("{'descr': '<f8', ") && header.contains(&shape) && header.ends_with('\n'), "{header}");
    let numbers: Vec<[f64; 3]> = stress[10 + length..].chunks_exact(24).map(Packed::take).collect();
    assert_eq!(numbers, fields[0].stress);
}

/// Every array that a grid announces has as many bytes as it says and as its points or cells need.
#[test]
fn grids_for_vtk_hold_what_they_announce() {
    let (_, fields) = run("theorem-3-3", "structured", 1, Keep::All);
    let f = &fields[0];
    let points = f.nodes.len() + 3 * f.arcs.len();
    let text = vtu::bodies(f);
    assert!(text.contains(&format!("NumberOfPoints=\"{points}\" NumberOfCells=\"{}\"", f.triangles.len())));
    assert_eq!(array(&text, "Points").len(), 24 * points);
    assert_eq!(array(&text, "connectivity").len(), 8 * (3 * f.triangles.len() + 3 * f.arcs.len()));
    assert_eq!(array(&text, "von_mises"), packed::bytes(&f.von_mises));
    let zone = vtu::zone(f);
    assert_eq!(array(&zone, "pressure"), packed::bytes(&f.zone.pressure));
    assert_eq!(array(&zone, "types"), vec![3; f.zone.sides.len()]);
}

/// The bytes of a named array, after the eight that say how many they are.
fn array(text: &str, name: &str) -> Vec<u8> {
    let (_, after) = text.split_once(&format!("Name=\"{name}\"")).unwrap();
    let bytes = packed::from_base64(after.split('\n').nth(1).unwrap()).unwrap();
    assert_eq!(i64::take(&bytes[..8]) as usize, bytes.len() - 8);
    bytes[8..].to_vec()
}
