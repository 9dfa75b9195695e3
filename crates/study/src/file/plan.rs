//! How a case is computed: family, levels, reference, solver.

use super::degenerate;
use super::error::{Fault, refuse};
use super::number::Finite;
use super::raw::{CoarseName, FamilyName, RawFamily, RawLevels, RawReference, RawSolver, ReferenceName, SolverName};
use super::shape::point;
use super::spanned::Spanned;
use crate::family::{Family, refinements};
use crate::study::ReferencePlan;
use signorini_contact::solver::{Accuracy, Method, Settings};
use std::ops::Range;

/// Largest number of cells per unit that a level may ask for.
const MOST_CELLS: usize = 8192;

/// The family; `structured` if none is named.
pub fn family(raw: Option<&Spanned<RawFamily>>) -> Result<Family, Fault> {
    let Some(raw) = raw else { return Ok(Family::Structured) };
    let f = raw.get_ref();
    refuse_superfluous(f)?;
    let from_delaunay = f.coarse.as_ref().is_some_and(|c| *c.get_ref() == CoarseName::Delaunay);
    Ok(match f.name {
        FamilyName::Structured => Family::Structured,
        FamilyName::CrissCross => Family::CrissCross,
        FamilyName::UnionJack => Family::UnionJack,
        FamilyName::Perturbed => random(raw).map(|(seed, amount)| Family::Perturbed { seed, amount })?,
        FamilyName::Refined if from_delaunay => Family::RefinedDelaunay { seed: seed(raw)? },
        FamilyName::Refined => random(raw).map(|(seed, amount)| Family::Refined { seed, amount })?,
        FamilyName::Delaunay => Family::Delaunay { seed: seed(raw)? },
        FamilyName::Graded => graded(raw)?,
        FamilyName::Degenerate => degenerate::degenerate(raw)?,
    })
}

/// Fields that mean nothing for the family.
fn refuse_superfluous(f: &RawFamily) -> Result<(), Fault> {
    use FamilyName::{Degenerate, Delaunay, Graded, Perturbed, Refined};
    let from_delaunay = f.coarse.as_ref().is_some_and(|c| *c.get_ref() == CoarseName::Delaunay);
    let fields = [
        ("seed", f.seed.as_ref().map(Spanned::span), [Perturbed, Refined, Delaunay, Graded].contains(&f.name)),
        ("amount", f.amount.as_ref().map(Spanned::span), [Perturbed, Refined].contains(&f.name) && !from_delaunay),
        ("coarse", f.coarse.as_ref().map(Spanned::span), f.name == Refined),
        ("towards", f.towards.as_ref().map(Spanned::span), f.name == Graded),
        ("strength", f.strength.as_ref().map(Spanned::span), [Graded, Degenerate].contains(&f.name)),
        ("direction", f.direction.as_ref().map(Spanned::span), f.name == Degenerate),
        ("triangles", f.triangles.as_ref().map(Spanned::span), f.name == Degenerate),
    ];
    match fields.into_iter().find_map(|(name, span, belongs)| span.filter(|_| !belongs).map(|s| (name, s))) {
        None => Ok(()),
        Some((name, span)) => refuse(span, format!("`{name}` says nothing about this family"), "leave it out"),
    }
}

fn seed(raw: &Spanned<RawFamily>) -> Result<u64, Fault> {
    match &raw.get_ref().seed {
        Some(seed) => Ok(*seed.get_ref()),
        None => refuse(raw.span(), "a Delaunay family needs `seed`", "give one, e.g. seed = 1"),
    }
}

fn graded(raw: &Spanned<RawFamily>) -> Result<Family, Fault> {
    let f = raw.get_ref();
    let (Some(towards), Some(strength)) = (&f.towards, &f.strength) else {
        let next = "give both, e.g. towards = [0, 0], strength = 0.5";
        return refuse(raw.span(), "a graded family needs `towards` and `strength`", next);
    };
    let gamma = strength.get_ref().0;
    if !(0.0 < gamma && gamma < 1.0) {
        return refuse(strength.span(), format!("strength = {gamma} must lie between 0 and 1"), "0.5 is a good choice");
    }
    Ok(Family::Graded { seed: seed(raw)?, towards: point(towards.get_ref()), strength: gamma })
}

fn random(raw: &Spanned<RawFamily>) -> Result<(u64, f64), Fault> {
    let f = raw.get_ref();
    let (Some(seed), Some(amount)) = (&f.seed, &f.amount) else {
        let message = "a random family needs `seed` and `amount`";
        return refuse(raw.span(), message, "give both, e.g. seed = 1, amount = 0.2");
    };
    let a = amount.get_ref().0;
    if !(0.0 < a && a < 0.5) {
        return refuse(amount.span(), format!("amount = {a} must lie between 0 and 0.5 cells"), "0.2 is a good choice");
    }
    Ok((*seed.get_ref(), a))
}

/// The reference; `exact` if the scene has an exact solution, else `overkill`.
pub fn reference(
    raw: Option<&Spanned<RawReference>>,
    has_exact: bool,
    place: Range<usize>,
) -> Result<ReferencePlan, Fault> {
    let by_default = if has_exact { ReferenceName::Exact } else { ReferenceName::Overkill };
    let kind = raw.map_or(by_default, |r| r.get_ref().kind);
    let span = raw.map_or(place, Spanned::span);
    let (quick, full) = raw.map_or((None, None), |r| (r.get_ref().quick.as_ref(), r.get_ref().full.as_ref()));
    if let (true, Some(n)) = (kind != ReferenceName::Overkill, quick.or(full)) {
        return refuse(n.span(), "`quick` and `full` belong to an overkill reference", "leave them out");
    }
    match kind {
        ReferenceName::Exact if !has_exact => {
            refuse(span, "reference `exact`, but the scene has no exact solution", "add [exact], or choose `overkill`")
        }
        ReferenceName::Exact => Ok(ReferencePlan::Exact),
        ReferenceName::None => Ok(ReferencePlan::None),
        ReferenceName::Overkill => Ok(ReferencePlan::Overkill { quick: cells(quick, 256)?, full: cells(full, 1024)? }),
    }
}

/// Whether the levels project the reference onto `K_h` instead of solving the scene's own problem.
pub fn projects(raw: Option<&Spanned<RawReference>>, is_located: bool) -> Result<bool, Fault> {
    let Some((kind, project)) = raw.and_then(|r| Some((r.get_ref().kind, r.get_ref().project.as_ref()?))) else {
        return Ok(false);
    };
    let is_ready = kind == ReferenceName::Exact || kind == ReferenceName::Overkill && !is_located;
    match *project.get_ref() {
        true if !is_ready => refuse(
            project.span(),
            "`project` of a reference that is neither exact nor nested above the levels",
            "give an exact solution, or straight bodies and a nested family",
        ),
        given => Ok(given),
    }
}

fn cells(raw: Option<&Spanned<usize>>, default: usize) -> Result<usize, Fault> {
    let Some(raw) = raw else { return Ok(default) };
    in_range(*raw.get_ref(), raw.span())
}

fn in_range(n: usize, span: Range<usize>) -> Result<usize, Fault> {
    if (1..=MOST_CELLS).contains(&n) {
        return Ok(n);
    }
    refuse(span, format!("{n} cells, where 1 to {MOST_CELLS} are possible"), "choose, e.g., [8, 16, 32, 64, 128]")
}

/// The levels of the quick and the full profile. Only a control may repeat a mesh. On curved bodies a reference need not be a
/// refinement of the levels, except where the family is made by refinement.
pub fn levels(
    raw: Option<&RawLevels>,
    family: &Family,
    is_curved: bool,
    reference: &ReferencePlan,
    control: bool,
    place: Range<usize>,
) -> Result<[Vec<usize>; 2], Fault> {
    let (quick, full) = raw.map_or((None, None), |r| (r.quick.as_ref(), r.full.as_ref()));
    let (last, ends) = match reference {
        ReferencePlan::Overkill { quick, full } => ([64, 128], Some([*quick, *full])),
        _ => ([128, 512], None),
    };
    let place = |list: Option<&Spanned<Vec<usize>>>| list.map_or(place.clone(), Spanned::span);
    let (quick_place, full_place) = (place(quick), place(full));
    let lists = [profile(quick, last[0], control)?, profile(full, last[1], control)?];
    if family.is_refined() {
        halved(&lists[0], quick_place.clone())?;
        halved(&lists[1], full_place.clone())?;
    }
    if let Some([end_quick, end_full]) = ends {
        let by_halving = family.is_refined() || (family.is_nested() && !is_curved);
        let fits = if by_halving { nested } else { finer };
        fits(&lists[0], end_quick, quick_place)?;
        fits(&lists[1], end_full, full_place)?;
    }
    Ok(lists)
}

/// Where the levels are stated: the full profile's or the quick one's list, else `place`.
pub fn levels_place(raw: Option<&RawLevels>, place: Range<usize>) -> Range<usize> {
    let lists = raw.and_then(|r| r.quick.as_ref().or(r.full.as_ref()));
    lists.map_or(place, Spanned::span)
}

fn profile(raw: Option<&Spanned<Vec<usize>>>, last: usize, control: bool) -> Result<Vec<usize>, Fault> {
    let Some(raw) = raw else { return Ok(doubling(last)) };
    let list = raw.get_ref();
    if list.is_empty() {
        return refuse(raw.span(), "no levels", "give at least one; a rate needs four");
    }
    for &n in list {
        in_range(n, raw.span())?;
    }
    match list.windows(2).find(|w| w[0] >= w[1]) {
        Some(w) if !control => {
            refuse(raw.span(), format!("level {} does not refine level {}", w[1], w[0]), "let the levels grow")
        }
        _ => Ok(list.clone()),
    }
}

fn doubling(last: usize) -> Vec<usize> {
    std::iter::successors(Some(8), |n| Some(2 * n)).take_while(|n| *n <= last).collect()
}

/// A refined family comes from its coarsest mesh by halving alone.
fn halved(levels: &[usize], span: Range<usize>) -> Result<(), Fault> {
    match levels.iter().find(|n| refinements(levels[0], **n).is_none()) {
        None => Ok(()),
        Some(n) => {
            let message = format!("a refined family of {} cells never has {n}", levels[0]);
            refuse(span, message, "let every level be the first one times a power of two")
        }
    }
}

fn nested(levels: &[usize], reference: usize, span: Range<usize>) -> Result<(), Fault> {
    let refines = |n: usize| refinements(n, reference).is_some_and(|steps| steps > 0);
    match levels.iter().find(|n| !refines(**n)) {
        None => Ok(()),
        Some(n) => {
            let message = format!("the reference of {reference} cells does not arise from {n} cells by halving");
            refuse(span, message, "let the reference be a level's number times a power of two, and finer than all")
        }
    }
}

fn finer(levels: &[usize], reference: usize, span: Range<usize>) -> Result<(), Fault> {
    match levels.iter().find(|n| **n >= reference) {
        None => Ok(()),
        Some(n) => {
            let message = format!("the reference of {reference} cells is no finer than the level of {n}");
            refuse(span, message, "let the reference be several times finer than every level")
        }
    }
}

fn method(name: SolverName) -> Method {
    match name {
        SolverName::Condensed => Method::Condensed,
        SolverName::Monotone => Method::Monotone,
        SolverName::InteriorPoint => Method::InteriorPoint,
        SolverName::Multigrid => Method::Multigrid,
    }
}

/// The method where a study names none.
const METHOD: Method = Method::Automatic;

/// Who gives the second opinion; not the solver whose answer it is held against.
pub fn second(raw: Option<&RawSolver>) -> Result<Option<Method>, Fault> {
    let Some(second) = raw.and_then(|r| r.second.as_ref()) else { return Ok(None) };
    let first = raw.and_then(|r| r.name).map_or(Method::Condensed, method);
    let other = method(*second.get_ref());
    if other == first {
        let message = format!("`second` is {} like the first solver: it would agree with itself", other.name());
        return refuse(second.span(), message, "choose another: condensed, multigrid, monotone or interior-point");
    }
    Ok(Some(other))
}

fn accuracy(share: &Spanned<Finite>) -> Result<Accuracy, Fault> {
    match share.get_ref().0 {
        0.0 => Ok(Accuracy::Floor),
        share if 0.0 < share && share < 1.0 => Ok(Accuracy::Discretisation(share)),
        other => {
            let message = format!("accuracy = {other} is no share of the discretisation error below 1");
            refuse(share.span(), message, "0, the default, asks for all that double precision gives")
        }
    }
}

/// Solver settings.
pub fn solver(raw: Option<&RawSolver>) -> Result<Settings, Fault> {
    let mut settings = Settings { method: METHOD, ..Settings::default() };
    let Some(raw) = raw else { return Ok(settings) };
    settings.method = raw.name.map_or(METHOD, method);
    if let Some(t) = &raw.tolerance {
        settings.tolerance = t.get_ref().0;
        if !(0.0 < settings.tolerance && settings.tolerance < 1.0) {
            let message = format!("tolerance = {} must lie between 0 and 1", settings.tolerance);
            return refuse(t.span(), message, "1e-11 is the default");
        }
    }
    if let Some(steps) = &raw.max_steps {
        settings.max_steps = *steps.get_ref();
        if settings.max_steps == 0 {
            return refuse(steps.span(), "max_steps = 0 leaves nothing to do", "50 is the default");
        }
    }
    if let Some(start) = &raw.start_slide {
        settings.start_slide = start.get_ref().0;
    }
    if let Some(share) = &raw.accuracy {
        settings.accuracy = accuracy(share)?;
    }
    settings.crossover = raw.crossover.unwrap_or(settings.crossover);
    Ok(settings)
}
