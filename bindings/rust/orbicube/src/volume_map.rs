//! Maps of tetrahedral meshes without inverted tetrahedra.

use crate::call::{call, expect_length, pointer, rows, Error, Host};
use crate::sys::base::OBC_NO_VALID_RESULT;
use crate::sys::volume_map::*;

filled!(/// Options, with their defaults.
    UntangleOptions, obc_volume_map_untangle_options, obc_volume_map_untangle_options_init);
filled!(/// Figures of a run.
    UntangleReport, obc_volume_map_untangle_report, obc_volume_map_untangle_report_init);

/// A mesh to untangle; empty: none.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tangle<'a> {
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
pub fn untangle(tangle: &Tangle, options: &UntangleOptions, host: &mut Host) -> Result<(Vec<f64>, UntangleReport), Error> {
    let (result, report, outcome) = best_of(tangle, options, host)?;
    outcome.map(|_| (result, report))
}

/// The same; where some stay inverted, the best that was found, and the error beside it.
pub fn untangle_best(tangle: &Tangle, options: &UntangleOptions,
                     host: &mut Host) -> Result<(Vec<f64>, UntangleReport, Option<Error>), Error> {
    match best_of(tangle, options, host)? {
        (result, report, Ok(())) => Ok((result, report, None)),
        (result, report, Err(error)) if error.status == OBC_NO_VALID_RESULT => Ok((result, report, Some(error))),
        (_, _, Err(error)) => Err(error),
    }
}

type Best = (Vec<f64>, UntangleReport, Result<(), Error>);

fn best_of(tangle: &Tangle, options: &UntangleOptions, host: &mut Host) -> Result<Best, Error> {
    let n = tangle.positions.len();
    let mut c: obc_volume_map_tangle = unsafe { std::mem::zeroed() };
    unsafe { obc_volume_map_tangle_init(&mut c, std::mem::size_of::<obc_volume_map_tangle>()) };
    c.positions = pointer(tangle.positions);
    c.vertex_count = rows(n, 3, "positions")?;
    c.tetrahedra = pointer(tangle.tetrahedra);
    c.tetrahedron_count = rows(tangle.tetrahedra.len(), 4, "tetrahedra")?;
    for (length, what) in [(tangle.rest.len(), "rest"), (tangle.fixed.len(), "fixed"), (tangle.ties.len(), "ties")] {
        if length != 0 {
            expect_length(length, n, what)?;
        }
    }
    c.rest = pointer(tangle.rest);
    c.fixed = pointer(tangle.fixed);
    c.ties = pointer(tangle.ties);
    let (mut result, mut report) = (vec![0.0; n], UntangleReport::default());
    let outcome = call(host, |host, error| unsafe {
        obc_volume_map_untangle(&c, &options.0, host, result.as_mut_ptr(), &mut report.0, error)
    });
    Ok((result, report, outcome))
}
