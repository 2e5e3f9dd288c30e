//! Spherical harmonics of scattered samples and of shapes.

use std::path::Path;

use crate::call::{c_path, call, checked, expect_length, pointer, rows, Error, Host};
use crate::sys::harmonics::*;

filled!(/// Options of a fit, with their defaults.
    FitOptions, obc_harmonics_fit_options, obc_harmonics_fit_options_init);
filled!(/// What a fit is like.
    FitReport, obc_harmonics_fit_report, obc_harmonics_fit_report_init);
filled!(/// What a refinement of a map has found.
    RefinementReport, obc_harmonics_refinement_report, obc_harmonics_refinement_report_init);
filled!(/// Options of an alignment, with their defaults.
    AlignOptions, obc_harmonics_align_options, obc_harmonics_align_options_init);
filled!(/// What an alignment has found.
    Alignment, obc_harmonics_alignment, obc_harmonics_alignment_init);

/// Of `channels` functions up to a degree: that of Y_lm in channel c at (l*l + l + m) * channels + c.
#[derive(Clone, Debug, PartialEq)]
pub struct Coefficients {
    degree: u32,
    channels: usize,
    /// (degree + 1)^2 * channels numbers.
    values: Vec<f64>,
}

impl Coefficients {
    pub fn new(degree: u32, channels: usize, values: Vec<f64>) -> Result<Coefficients, Error> {
        expect_length(values.len(), size(degree, channels)?, "coefficients")?;
        Ok(Coefficients { degree, channels, values })
    }
    fn zeros(degree: u32, channels: usize) -> Result<Coefficients, Error> {
        let (mut values, size) = (vec![], size(degree, channels)?);
        values.try_reserve_exact(size).map_err(|_| Error::out_of_memory())?;
        values.resize(size, 0.0);
        Ok(Coefficients { degree, channels, values })
    }
    pub fn degree(&self) -> u32 {
        self.degree
    }
    pub fn channels(&self) -> usize {
        self.channels
    }
    pub fn values(&self) -> &[f64] {
        &self.values
    }
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }
    /// The functions at the directions.
    pub fn synthesize(&self, directions: &[f64], host: &mut Host) -> Result<Vec<f64>, Error> {
        let n = rows(directions.len(), 3, "directions")?;
        let mut values = vec![0.0; n * self.channels];
        call(host, |host, error| unsafe {
            obc_harmonics_synthesize(self.values.as_ptr(), self.degree, self.channels, directions.as_ptr(), n, host,
                                     values.as_mut_ptr(), std::ptr::null_mut(), error)
        })?;
        Ok(values)
    }
    /// Their gradients on the unit sphere: x y z for each direction and channel.
    pub fn gradients(&self, directions: &[f64], host: &mut Host) -> Result<Vec<f64>, Error> {
        let n = rows(directions.len(), 3, "directions")?;
        let (mut values, mut slopes) = (vec![0.0; n * self.channels], vec![0.0; 3 * n * self.channels]);
        call(host, |host, error| unsafe {
            obc_harmonics_synthesize(self.values.as_ptr(), self.degree, self.channels, directions.as_ptr(), n, host,
                                     values.as_mut_ptr(), slopes.as_mut_ptr(), error)
        })?;
        Ok(slopes)
    }
    /// The norm of each degree.
    pub fn degree_norms(&self) -> Result<Vec<f64>, Error> {
        let mut norms = vec![0.0; self.degree as usize + 1];
        checked(|error| unsafe {
            obc_harmonics_degree_norms(self.values.as_ptr(), self.degree, self.channels, norms.as_mut_ptr(), error)
        })?;
        Ok(norms)
    }
    /// Turned with the sphere by a matrix, by rows.
    pub fn rotate(&self, rotation: &[f64; 9], host: &mut Host) -> Result<Coefficients, Error> {
        let mut turned = Coefficients::zeros(self.degree, self.channels)?;
        call(host, |host, error| unsafe {
            obc_harmonics_rotate(self.values.as_ptr(), self.degree, self.channels, rotation.as_ptr(), host,
                                 turned.values.as_mut_ptr(), error)
        })?;
        Ok(turned)
    }
    /// Degrees from low to high stay.
    pub fn filter(&mut self, low: u32, high: u32, width: u32, keep_mean: bool) -> Result<(), Error> {
        checked(|error| unsafe {
            obc_harmonics_filter(self.values.as_mut_ptr(), self.degree, self.channels, low, high, width, i32::from(keep_mean), error)
        })
    }
    /// To a file of SHTOOLS or SPHARM-PDM: `OBC_HARMONICS_BY_ENDING`, ...
    pub fn write(&self, path: impl AsRef<Path>, format: i32) -> Result<(), Error> {
        let path = c_path(path.as_ref())?;
        checked(|error| unsafe {
            obc_harmonics_write(path.as_ptr(), format, self.values.as_ptr(), self.degree, self.channels, error)
        })
    }
    pub fn read(path: impl AsRef<Path>, format: i32, host: &mut Host) -> Result<Coefficients, Error> {
        let path = c_path(path.as_ref())?;
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe { obc_harmonics_read(path.as_ptr(), format, host, &mut out, error) })?;
        let handle = Handle::own(out);
        let mut found = unsafe {
            Coefficients::zeros(obc_harmonics_coefficients_degree(handle.as_ptr()),
                                obc_harmonics_coefficients_channels(handle.as_ptr()))?
        };
        checked(|error| unsafe { obc_harmonics_coefficients_copy(handle.as_ptr(), found.values.as_mut_ptr(), error) })?;
        Ok(found)
    }
}

/// How many numbers; an error for impossible numbers.
fn size(degree: u32, channels: usize) -> Result<usize, Error> {
    (degree as usize + 1).checked_pow(2).and_then(|count| count.checked_mul(channels))
        .ok_or_else(|| Error::invalid(format!("degree {degree} with {channels} channels")))
}

handle!(Handle, obc_harmonics_coefficients, obc_harmonics_coefficients_destroy);

/// Y_lm at each direction, a row of (degree + 1)^2 numbers each.
pub fn evaluate(directions: &[f64], degree: u32, host: &mut Host) -> Result<Vec<f64>, Error> {
    let n = rows(directions.len(), 3, "directions")?;
    let mut found = Coefficients::zeros(degree, n)?.values;
    call(host, |host, error| unsafe { obc_harmonics_evaluate(directions.as_ptr(), n, degree, host, found.as_mut_ptr(), error) })?;
    Ok(found)
}

/// The coefficients that fit values at scattered directions best. weights: one a direction, or none.
pub fn fit(directions: &[f64], weights: &[f64], values: &[f64], channels: usize, options: &FitOptions,
           host: &mut Host) -> Result<(Coefficients, FitReport), Error> {
    let n = rows(directions.len(), 3, "directions")?;
    expect_length(values.len(), n * channels, "values")?;
    if !weights.is_empty() {
        expect_length(weights.len(), n, "weights")?;
    }
    let (mut fitted, mut report) = (Coefficients::zeros(options.degree, channels)?, FitReport::default());
    call(host, |host, error| unsafe {
        obc_harmonics_fit(directions.as_ptr(), pointer(weights), values.as_ptr(), n, channels, &options.0, host,
                          fitted.values.as_mut_ptr(), &mut report.0, error)
    })?;
    Ok((fitted, report))
}

/// A sphere map moved to where the surface of the degree of the options comes nearest to the vertices; `weights` may be empty.
pub fn refine_map(positions: &[f64], triangles: &[u32], directions: &[f64], weights: &[f64], options: &FitOptions, rounds: u32,
                  host: &mut Host) -> Result<(Vec<f64>, RefinementReport), Error> {
    let (n, count) = (rows(positions.len(), 3, "positions")?, rows(triangles.len(), 3, "triangles")?);
    expect_length(directions.len(), 3 * n, "directions")?;
    if !weights.is_empty() {
        expect_length(weights.len(), n, "weights")?;
    }
    let (mut moved, mut report) = (directions.to_vec(), RefinementReport::default());
    call(host, |host, error| unsafe {
        obc_harmonics_refine_map(positions.as_ptr(), n, triangles.as_ptr(), count, pointer(weights), &options.0, rounds, host,
                                 moved.as_mut_ptr(), &mut report.0, error)
    })?;
    Ok((moved, report))
}

/// The distance D_n, over the degrees from first to last.
pub fn shape_distance(f: &Coefficients, g: &Coefficients, first: u32, last: u32) -> Result<f64, Error> {
    expect_length(g.channels, f.channels, "channels")?;
    let mut distance = 0.0;
    checked(|error| unsafe {
        obc_harmonics_shape_distance(f.values.as_ptr(), f.degree, g.values.as_ptr(), g.degree, f.channels, first, last,
                                     &mut distance, error)
    })?;
    Ok(distance)
}

/// The rotation that brings `moving` best into line with `fixed`.
pub fn align(fixed: &Coefficients, moving: &Coefficients, options: &AlignOptions, host: &mut Host) -> Result<Alignment, Error> {
    expect_length(moving.channels, fixed.channels, "channels")?;
    let mut found = Alignment::default();
    call(host, |host, error| unsafe {
        obc_harmonics_align(fixed.values.as_ptr(), fixed.degree, moving.values.as_ptr(), moving.degree, fixed.channels,
                            &options.0, host, &mut found.0, error)
    })?;
    Ok(found)
}
