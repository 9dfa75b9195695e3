//! The blessed numbers of a study, `reference/<id>.json`: energies, errors and rates with where they come from.
//!
//! The theory gates; the baseline warns of change.

use super::records::plain;
use super::{StoreError, read_json, write_json};
use crate::rate;
use crate::record::{Level, Rate, Reference, StudyRecord};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Stored numbers of all cases of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Baseline {
    /// Study id.
    pub study: String,
    /// Version of the program that computed it.
    pub version: String,
    /// By case name.
    pub cases: BTreeMap<String, BaselineCase>,
}

/// Stored numbers of a case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BaselineCase {
    /// Hash of the resolved scene, where the writer knew it.
    pub scene_hash: Option<String>,
    /// Profile of the run.
    pub profile: String,
    /// Dofs of the discrete reference that the errors were measured against; `None` for another kind of reference.
    pub reference_dofs: Option<usize>,
    /// From the coarsest to the finest.
    pub levels: Vec<BaselineLevel>,
    /// Slopes by name of the error norm; the terms of the ledger follow from errors that are stored.
    pub rates: BTreeMap<String, f64>,
}

/// Stored numbers of a level.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BaselineLevel {
    /// Mesh size.
    pub h: f64,
    /// Free displacement components.
    pub dofs: usize,
    /// Hash of the mesh.
    pub mesh_hash: String,
    /// `L(u_h)`.
    pub energy: f64,
    /// Strain seminorm of the error.
    pub strain_error: Option<f64>,
    /// Energy norm of the error.
    pub energy_error: Option<f64>,
    /// Interpolation error on the boundary, of a lemma.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub boundary_error: Option<f64>,
    /// Constant of an estimate, of a lemma.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub constant: Option<f64>,
    /// Solver.
    pub solver: String,
    /// Scaled stationarity residual.
    pub stationarity: f64,
}

impl Baseline {
    /// The baseline of a study from the records of all its cases; `scene_hashes` by case name, `version` of this program.
    /// `None` without records.
    pub fn from_records(
        records: &[StudyRecord],
        scene_hashes: &BTreeMap<String, String>,
        version: &str,
    ) -> Option<Self> {
        let case = |r: &StudyRecord| {
            let scene_hash = scene_hashes.get(&r.case).cloned();
            (r.case.clone(), BaselineCase::of(r, scene_hash))
        };
        Some(Self {
            study: records.first()?.study.clone(),
            version: version.into(),
            cases: records.iter().map(case).collect(),
        })
    }

    /// The file of a study's baseline in `folder`.
    ///
    /// # Errors
    /// [`StoreError::Name`] where the id cannot name a file.
    pub fn path(folder: &Path, study: &str) -> Result<PathBuf, StoreError> {
        Ok(folder.join(format!("{}.json", plain(study)?)))
    }

    /// Reads the baseline of a study in `folder`, if there is one.
    ///
    /// # Errors
    /// [`StoreError`] where it cannot be read or is malformed.
    pub fn read(folder: &Path, study: &str) -> Result<Option<Self>, StoreError> {
        let path = Self::path(folder, study)?;
        if path.is_file() { read_json(&path).map(Some) } else { Ok(None) }
    }

    /// Writes it in `folder` and returns the file.
    ///
    /// # Errors
    /// [`StoreError`] where a number is not finite or the file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, StoreError> {
        let path = Self::path(folder, &self.study)?;
        write_json(&path, self)?;
        Ok(path)
    }
}

impl BaselineCase {
    fn of(record: &StudyRecord, scene_hash: Option<String>) -> Self {
        Self {
            scene_hash,
            profile: record.profile.clone(),
            reference_dofs: reference_dofs(record),
            levels: record.levels.iter().map(BaselineLevel::from).collect(),
            rates: norm_rates(record).map(|(name, rate)| (name.clone(), rate.slope)).collect(),
        }
    }
}

/// The rates of a record that a baseline keeps: all but those of the ledger's terms.
pub(super) fn norm_rates(record: &StudyRecord) -> impl Iterator<Item = (&String, &Rate)> {
    record.rates.iter().filter(|(name, _)| !name.starts_with(rate::LEDGER))
}

/// Dofs of a record's discrete reference.
pub(super) fn reference_dofs(record: &StudyRecord) -> Option<usize> {
    match record.reference {
        Reference::Overkill { dofs, .. } => Some(dofs),
        Reference::Exact | Reference::None => None,
    }
}

impl From<&Level> for BaselineLevel {
    fn from(level: &Level) -> Self {
        Self {
            h: level.h,
            dofs: level.dofs,
            mesh_hash: level.mesh_hash.clone(),
            energy: level.energy,
            strain_error: level.errors.strain,
            energy_error: level.errors.energy,
            boundary_error: level.errors.boundary_l2,
            constant: level.errors.constant,
            solver: level.solver.name.clone(),
            stationarity: level.kkt.stationarity,
        }
    }
}
