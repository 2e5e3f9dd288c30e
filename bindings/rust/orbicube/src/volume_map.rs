//! Maps of tetrahedral meshes without inverted tetrahedra.
//!
//! ```
//! use orbicube::{volume_map, Host};
//! let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
//! let solid = volume_map::map_to_polycube(&corners, &[0, 1, 2, 3], &Default::default(), &mut Host::new())?;
//! assert!(solid.tetrahedra.len() >= 4);
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{call, checked, expect_length, pointer, rows, Error, Host};
use crate::sys::base::OBC_NO_VALID_RESULT;
use crate::sys::volume_map::*;

filled!(/// Options, with their defaults.
    UntangleOptions, obc_volume_map_untangle_options, obc_volume_map_untangle_options_init);
filled!(/// Figures of a run.
    UntangleReport, obc_volume_map_untangle_report, obc_volume_map_untangle_report_init);

/// A mesh to untangle; empty: none.
#[derive(Clone, Copy, Debug, Default)]
pub struct UntangleProblem<'a> {
    pub positions: &'a [f64],
    pub tetrahedra: &'a [u32],
    /// Positions where each tetrahedron has the shape that it should have.
    pub rest: &'a [f64],
    /// One a coordinate, not 0 where it stays.
    pub fixed: &'a [u8],
    /// One a coordinate: its group, or `u32::MAX`.
    pub ties: &'a [u32],
}

/// Moves vertices until every tetrahedron is positive.
pub fn untangle(problem: &UntangleProblem, options: &UntangleOptions, host: &mut Host) -> Result<(Vec<f64>, UntangleReport), Error> {
    let (result, report, outcome) = best_of(problem, options, host)?;
    outcome.map(|_| (result, report))
}

/// The same; where some stay inverted, the best that was found, and the error beside it.
pub fn untangle_best(problem: &UntangleProblem, options: &UntangleOptions,
                     host: &mut Host) -> Result<(Vec<f64>, UntangleReport, Option<Error>), Error> {
    match best_of(problem, options, host)? {
        (result, report, Ok(())) => Ok((result, report, None)),
        (result, report, Err(error)) if error.status == OBC_NO_VALID_RESULT => Ok((result, report, Some(error))),
        (_, _, Err(error)) => Err(error),
    }
}

type Best = (Vec<f64>, UntangleReport, Result<(), Error>);

fn best_of(problem: &UntangleProblem, options: &UntangleOptions, host: &mut Host) -> Result<Best, Error> {
    let n = problem.positions.len();
    let mut c: obc_volume_map_untangle_problem = unsafe { std::mem::zeroed() };
    unsafe { obc_volume_map_untangle_problem_init(&mut c, std::mem::size_of::<obc_volume_map_untangle_problem>()) };
    c.positions = pointer(problem.positions);
    c.vertex_count = rows(n, 3, "positions")?;
    c.tetrahedra = pointer(problem.tetrahedra);
    c.tetrahedron_count = rows(problem.tetrahedra.len(), 4, "tetrahedra")?;
    for (length, what) in [(problem.rest.len(), "rest"), (problem.fixed.len(), "fixed"), (problem.ties.len(), "ties")] {
        if length != 0 {
            expect_length(length, n, what)?;
        }
    }
    c.rest = pointer(problem.rest);
    c.fixed = pointer(problem.fixed);
    c.ties = pointer(problem.ties);
    let (mut result, mut report) = (vec![0.0; n], UntangleReport::default());
    let outcome = call(host, |host, error| unsafe {
        obc_volume_map_untangle(&c, &options.0, host, result.as_mut_ptr(), &mut report.0, error)
    });
    Ok((result, report, outcome))
}

filled!(/// Options of the map to a polycube, with their defaults.
    SolidOptions, obc_volume_map_solid_options, obc_volume_map_solid_options_init);
/// A solid, and the same on the polycube of its boundary.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solid {
    pub positions: Vec<f64>,
    pub polycube: Vec<f64>,
    /// Of both: four vertices each, positive here and there.
    pub tetrahedra: Vec<u32>,
}

handle!(SolidHandle, obc_volume_map_solid, obc_volume_map_solid_destroy);

/// Maps positive tetrahedra one to one to a polycube, splitting them where that is needed.
pub fn map_to_polycube(positions: &[f64], tetrahedra: &[u32], options: &SolidOptions, host: &mut Host) -> Result<Solid, Error> {
    let (vertices, cells) = (rows(positions.len(), 3, "positions")?, rows(tetrahedra.len(), 4, "tetrahedra")?);
    let mut out = std::ptr::null_mut();
    call(host, |host, error| unsafe {
        obc_volume_map_solid_compute(pointer(positions), vertices, pointer(tetrahedra), cells, &options.0, host, &mut out, error)
    })?;
    let handle = SolidHandle::own(out);
    let out = handle.as_ptr();
    let mut solid = Solid::default();
    unsafe {
        solid.positions.resize(3 * obc_volume_map_solid_vertex_count(out), 0.0);
        solid.polycube.resize(solid.positions.len(), 0.0);
        solid.tetrahedra.resize(4 * obc_volume_map_solid_tetrahedron_count(out), 0);
        checked(|error| {
            obc_volume_map_solid_copy(out, solid.positions.as_mut_ptr(), solid.polycube.as_mut_ptr(),
                                      solid.tetrahedra.as_mut_ptr(), error)
        })?;
    }
    Ok(solid)
}
