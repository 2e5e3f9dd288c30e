//! Meshes without inverted elements.
//!
//! ```
//! use orbicube::{untangle, Host};
//! // Four tetrahedra around a vertex that has left the one that they fill.
//! let positions = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0];
//! let tetrahedra = [0, 1, 2, 4, 0, 2, 3, 4, 0, 3, 1, 4, 1, 3, 2, 4];
//! let problem = untangle::Tetrahedra { positions: &positions, tetrahedra: &tetrahedra, ..Default::default() };
//! let (untangled, report) = untangle::tetrahedra(&problem, &Default::default(), &mut Host::new())?;
//! assert!(report.inverted == 0 && untangled[..12] == positions[..12]);
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{call, checked, expect_length, pointer, rows, Error, Host};
use crate::sys::base::OBC_NO_VALID_RESULT;
use crate::sys::untangle::*;

filled!(/// Options, with their defaults.
    Options, obc_untangle_options, obc_untangle_options_init);
filled!(/// Figures of a run.
    Report, obc_untangle_report, obc_untangle_report_init);

/// A mesh to untangle; empty: none.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tetrahedra<'a> {
    pub positions: &'a [f64],
    pub tetrahedra: &'a [u32],
    /// Positions in which each tetrahedron has its target shape.
    pub rest: &'a [f64],
    /// One a vertex, not 0 for a fixed one. Without these and fixed coordinates the boundary is fixed, unless it is free by the options.
    pub fixed: &'a [u8],
    /// One a coordinate, not 0 for a fixed one.
    pub fixed_coordinates: &'a [u8],
    /// One a coordinate: its group, or `u32::MAX`.
    pub ties: &'a [u32],
}

/// Positions, figures, and the error where some elements remain inverted.
pub type Best = (Vec<f64>, Report, Option<Error>);

/// Moves vertices until every tetrahedron is positive.
pub fn tetrahedra(problem: &Tetrahedra, options: &Options, host: &mut Host) -> Result<(Vec<f64>, Report), Error> {
    certain(tetrahedra_best(problem, options, host)?)
}

/// The same; where some remain inverted, the best positions found, and the error beside them.
pub fn tetrahedra_best(problem: &Tetrahedra, options: &Options, host: &mut Host) -> Result<Best, Error> {
    let c = tetrahedra_problem(problem)?;
    let (mut result, mut report) = (vec![0.0; problem.positions.len()], Report::default());
    let outcome = call(host, |host, error| unsafe {
        obc_untangle_tetrahedra(&c, &options.0, host, result.as_mut_ptr(), &mut report.0, error)
    });
    best_of(result, report, outcome)
}

/// A flat mesh to untangle; empty: none.
#[derive(Clone, Copy, Debug, Default)]
pub struct Triangles<'a> {
    /// x y a vertex.
    pub positions: &'a [f64],
    pub triangles: &'a [u32],
    /// Positions in which each triangle has its target shape, x y z a vertex.
    pub rest: &'a [f64],
    /// As of [`Tetrahedra`].
    pub fixed: &'a [u8],
    pub fixed_coordinates: &'a [u8],
    pub ties: &'a [u32],
}

/// Moves vertices in the plane until every triangle is positive.
pub fn triangles(problem: &Triangles, options: &Options, host: &mut Host) -> Result<(Vec<f64>, Report), Error> {
    certain(triangles_best(problem, options, host)?)
}

/// The same; where some remain inverted, the best positions found, and the error beside them.
pub fn triangles_best(problem: &Triangles, options: &Options, host: &mut Host) -> Result<Best, Error> {
    let c = triangles_problem(problem)?;
    let (mut result, mut report) = (vec![0.0; problem.positions.len()], Report::default());
    let outcome = call(host, |host, error| unsafe {
        obc_untangle_triangles(&c, &options.0, host, result.as_mut_ptr(), &mut report.0, error)
    });
    best_of(result, report, outcome)
}

fn best_of(result: Vec<f64>, report: Report, outcome: Result<(), Error>) -> Result<Best, Error> {
    match outcome {
        Ok(()) => Ok((result, report, None)),
        Err(error) if error.status == OBC_NO_VALID_RESULT => Ok((result, report, Some(error))),
        Err(error) => Err(error),
    }
}

fn certain((result, report, error): Best) -> Result<(Vec<f64>, Report), Error> {
    error.map_or(Ok((result, report)), Err)
}

/// Sets what both kinds of problems may have, of `$n` coordinates; empty: none.
macro_rules! set_constraints {
    ($c:ident, $problem:ident, $n:expr) => {
        for (length, wanted, what) in [($problem.rest.len(), 3 * $c.vertex_count, "rest"), ($problem.fixed.len(), $c.vertex_count, "fixed"),
                                       ($problem.fixed_coordinates.len(), $n, "fixed_coordinates"), ($problem.ties.len(), $n, "ties")] {
            if length != 0 {
                expect_length(length, wanted, what)?;
            }
        }
        $c.rest = pointer($problem.rest);
        $c.fixed = pointer($problem.fixed);
        $c.fixed_coordinates = pointer($problem.fixed_coordinates);
        $c.ties = pointer($problem.ties);
    };
}

fn tetrahedra_problem(problem: &Tetrahedra) -> Result<obc_untangle_tetrahedra_problem, Error> {
    let n = problem.positions.len();
    let mut c: obc_untangle_tetrahedra_problem = unsafe { std::mem::zeroed() };
    unsafe { obc_untangle_tetrahedra_problem_init(&mut c, std::mem::size_of::<obc_untangle_tetrahedra_problem>()) };
    c.positions = pointer(problem.positions);
    c.vertex_count = rows(n, 3, "positions")?;
    c.tetrahedra = pointer(problem.tetrahedra);
    c.tetrahedron_count = rows(problem.tetrahedra.len(), 4, "tetrahedra")?;
    set_constraints!(c, problem, n);
    Ok(c)
}

fn triangles_problem(problem: &Triangles) -> Result<obc_untangle_triangles_problem, Error> {
    let n = problem.positions.len();
    let mut c: obc_untangle_triangles_problem = unsafe { std::mem::zeroed() };
    unsafe { obc_untangle_triangles_problem_init(&mut c, std::mem::size_of::<obc_untangle_triangles_problem>()) };
    c.positions = pointer(problem.positions);
    c.vertex_count = rows(n, 2, "positions")?;
    c.triangles = pointer(problem.triangles);
    c.triangle_count = rows(problem.triangles.len(), 3, "triangles")?;
    set_constraints!(c, problem, n);
    Ok(c)
}

/// A mesh whose elements were split where that is needed; vertices of the mesh before come first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Refined {
    /// x y z a vertex; x y of a flat mesh.
    pub positions: Vec<f64>,
    pub elements: Vec<u32>,
    /// Of each element the one of the mesh before that it is part of.
    pub parents: Vec<u32>,
    /// Of each vertex those of the mesh before whose mean it is there, four each for tetrahedra and three for triangles; `u32::MAX` with
    /// weight 0 for the rest.
    pub origins: Vec<u32>,
    pub weights: Vec<f64>,
}

handle!(RefinedHandle, obc_untangle_refined, obc_untangle_refined_destroy);

/// As [`tetrahedra`], and splits tetrahedra where the mesh as it is has no solution, or none is found.
pub fn refine_tetrahedra(problem: &Tetrahedra, options: &Options, host: &mut Host) -> Result<(Refined, Report), Error> {
    let c = tetrahedra_problem(problem)?;
    let (mut out, mut report) = (std::ptr::null_mut(), Report::default());
    call(host, |host, error| unsafe { obc_untangle_refine_tetrahedra(&c, &options.0, host, &mut out, &mut report.0, error) })?;
    Ok((copied(RefinedHandle::own(out), 3)?, report))
}

/// As [`triangles`], and splits triangles where the mesh as it is has no solution, or none is found. A disk whose boundary is fixed to a
/// star-shaped polygon always has one.
pub fn refine_triangles(problem: &Triangles, options: &Options, host: &mut Host) -> Result<(Refined, Report), Error> {
    let c = triangles_problem(problem)?;
    let (mut out, mut report) = (std::ptr::null_mut(), Report::default());
    call(host, |host, error| unsafe { obc_untangle_refine_triangles(&c, &options.0, host, &mut out, &mut report.0, error) })?;
    Ok((copied(RefinedHandle::own(out), 2)?, report))
}

fn copied(handle: RefinedHandle, axes: usize) -> Result<Refined, Error> {
    let out = handle.as_ptr();
    let (n, m) = unsafe { (obc_untangle_refined_vertex_count(out), obc_untangle_refined_element_count(out)) };
    let mut refined = Refined {
        positions: vec![0.0; axes * n],
        elements: vec![0; (axes + 1) * m],
        parents: vec![0; m],
        origins: vec![0; (axes + 1) * n],
        weights: vec![0.0; (axes + 1) * n],
    };
    checked(|error| unsafe {
        obc_untangle_refined_copy(out, refined.positions.as_mut_ptr(), refined.elements.as_mut_ptr(), refined.parents.as_mut_ptr(),
                                  refined.origins.as_mut_ptr(), refined.weights.as_mut_ptr(), error)
    })?;
    Ok(refined)
}
