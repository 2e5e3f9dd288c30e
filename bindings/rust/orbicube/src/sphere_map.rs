//! Bijective, low-distortion maps of closed genus-0 surfaces to the unit sphere, and what they are for.
//!
//! ```
//! use orbicube::{mesh::Mesh, sphere_map, Host};
//! let shape = Mesh::make("creature", 500, 0, &mut Host::new())?;
//! let (directions, report) = sphere_map::compute(shape.surface(), &Default::default(), &mut Host::new())?;
//! assert_eq!(report.bijective, 1);
//! let locator = sphere_map::Locator::new(shape.surface(), &directions, &mut Host::new())?;
//! let places = locator.locate(&[[0.0, 0.0, 1.0]], &mut Host::new())?;
//! # let _ = places;
//! # Ok::<(), orbicube::Error>(())
//! ```

use std::os::raw::c_void;
use std::path::Path;

use crate::call::{c_path, call, checked, expect_length, rows, Caught, Error, Host};
use crate::mesh::{Mesh, Surface};
use crate::sys::base::OBC_NO_VALID_RESULT;
use crate::sys::sphere_map::*;

filled!(/// Options, with their defaults.
    Options, obc_sphere_map_options, obc_sphere_map_options_init);
filled!(/// Figures of a map.
    Report, obc_sphere_map_report, obc_sphere_map_report_init);

/// Unit vectors, x y z a vertex, and the figures of the map. The member `trace` of the options is not used: [`compute_traced`].
pub fn compute(surface: Surface, options: &Options, host: &mut Host) -> Result<(Vec<f64>, Report), Error> {
    computed(surface, plain(options), host)
}

/// The same; `trace` receives the course of the method `OBC_SPHERE_MAP_DISSERTATION`: iterations, vertices, energy.
pub fn compute_traced<F: FnMut(u64, u64, f64)>(surface: Surface, options: &Options, trace: F,
                                               host: &mut Host) -> Result<(Vec<f64>, Report), Error> {
    struct Trace<F> {
        f: F,
        caught: Caught,
    }
    unsafe extern "C" fn traced<F: FnMut(u64, u64, f64)>(iterations: u64, vertices: u64, energy: f64, user: *mut c_void) {
        let Trace { f, caught } = &mut *(user as *mut Trace<F>);
        caught.guard(|| {
            f(iterations, vertices, energy);
            0
        });
    }
    let mut trace = Trace { f: trace, caught: Caught::default() };
    let mut options = plain(options);
    options.trace = Some(traced::<F>);
    options.trace_user = &mut trace as *mut Trace<F> as *mut c_void;
    let result = computed(surface, options, host);
    trace.caught.resume();
    result
}

/// Without what safe code could set to anything.
fn plain(options: &Options) -> obc_sphere_map_options {
    obc_sphere_map_options { trace: None, trace_user: std::ptr::null_mut(), ..options.0 }
}

fn computed(surface: Surface, options: obc_sphere_map_options, host: &mut Host) -> Result<(Vec<f64>, Report), Error> {
    let mut directions = vec![0.0; 3 * surface.vertex_count()];
    let mut report = Report::default();
    call(host, |host, error| unsafe {
        obc_sphere_map_compute(&surface.c, &options, host, directions.as_mut_ptr(), &mut report.0, error)
    })?;
    Ok((directions, report))
}

/// As [`compute`], and when that is cancelled or finds no valid result: what there is of the map, how many vertices have places of
/// their own, and the error beside it.
pub fn compute_partial(surface: Surface, options: &Options, host: &mut Host) -> Result<(Vec<f64>, usize, Option<Error>), Error> {
    let (mut directions, mut placed, options) = (vec![0.0; 3 * surface.vertex_count()], 0, plain(options));
    let outcome = call(host, |host, error| unsafe {
        obc_sphere_map_compute_partial(&surface.c, &options, host, directions.as_mut_ptr(), &mut placed, std::ptr::null_mut(), error)
    });
    match outcome {
        Ok(()) => Ok((directions, placed, None)),
        Err(error) if error.is_cancelled() || error.status == OBC_NO_VALID_RESULT => Ok((directions, placed, Some(error))),
        Err(error) => Err(error),
    }
}

/// Figures of any map; a bad one is no error.
pub fn measure(surface: Surface, directions: &[f64], options: &Options, host: &mut Host) -> Result<Report, Error> {
    expect_length(directions.len(), 3 * surface.vertex_count(), "directions")?;
    let (mut report, options) = (Report::default(), plain(options));
    call(host, |host, error| unsafe {
        obc_sphere_map_measure(&surface.c, directions.as_ptr(), &options, host, &mut report.0, error)
    })?;
    Ok(report)
}

/// Quasi-conformal distortion and area ratio of each triangle.
pub fn face_distortion(surface: Surface, directions: &[f64], host: &mut Host) -> Result<(Vec<f64>, Vec<f64>), Error> {
    expect_length(directions.len(), 3 * surface.vertex_count(), "directions")?;
    let (mut quasi_conformal, mut ratio) = (vec![0.0; surface.triangle_count()], vec![0.0; surface.triangle_count()]);
    call(host, |host, error| unsafe {
        obc_sphere_map_face_distortion(&surface.c, directions.as_ptr(), host, quasi_conformal.as_mut_ptr(), ratio.as_mut_ptr(), error)
    })?;
    Ok((quasi_conformal, ratio))
}

/// The map in 32-bit floats, repaired where rounding flips triangles.
pub fn round_to_float(surface: Surface, directions: &[f64], host: &mut Host) -> Result<Vec<f32>, Error> {
    expect_length(directions.len(), 3 * surface.vertex_count(), "directions")?;
    let mut rounded = vec![0.0; directions.len()];
    call(host, |host, error| unsafe {
        obc_sphere_map_round_to_float(&surface.c, directions.as_ptr(), host, rounded.as_mut_ptr(), error)
    })?;
    Ok(rounded)
}

/// A regular triangulation of the sphere: `OBC_SPHERE_MAP_ICOSPHERE`, ...
pub fn grid(grid: i32, resolution: usize, host: &mut Host) -> Result<Mesh, Error> {
    Mesh::made(host, |host, out, error| unsafe { obc_sphere_map_grid(grid, resolution, host, out, error) })
}

handle!(Handle, obc_sphere_map_locator, obc_sphere_map_locator_destroy);

/// The inverse of a map: which triangle a direction lies in.
pub struct Locator {
    handle: Handle,
    vertex_count: usize,
}

// Used by any number of threads at once, as the header says.
unsafe impl Send for Locator {}
unsafe impl Sync for Locator {}

impl Locator {
    pub fn new(surface: Surface, directions: &[f64], host: &mut Host) -> Result<Locator, Error> {
        expect_length(directions.len(), 3 * surface.vertex_count(), "directions")?;
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe {
            obc_sphere_map_locator_create(&surface.c, directions.as_ptr(), host, &mut out, error)
        })?;
        Ok(Locator { handle: Handle::own(out), vertex_count: surface.vertex_count() })
    }
    /// The triangle of each direction, and its weights at the corners.
    pub fn locate(&self, directions: &[[f64; 3]], host: &mut Host) -> Result<Vec<(u32, [f64; 3])>, Error> {
        let n = directions.len();
        let (mut triangles, mut weights) = (vec![0; n], vec![[0.0; 3]; n]);
        call(host, |host, error| unsafe {
            obc_sphere_map_locate(self.handle.as_ptr(), directions.as_ptr() as *const f64, n, host, triangles.as_mut_ptr(),
                                  weights.as_mut_ptr() as *mut f64, error)
        })?;
        Ok(triangles.into_iter().zip(weights).collect())
    }
    /// Values of the vertices, interpolated where each direction lies; `unit` scales each result to length 1.
    pub fn sample(&self, directions: &[[f64; 3]], values: &[f64], unit: bool, host: &mut Host) -> Result<Vec<f64>, Error> {
        let components = rows(values.len(), self.vertex_count, "values")?;
        let mut sampled = vec![0.0; components * directions.len()];
        call(host, |host, error| unsafe {
            obc_sphere_map_sample(self.handle.as_ptr(), directions.as_ptr() as *const f64, directions.len(), values.as_ptr(),
                                  components, i32::from(unit), host, sampled.as_mut_ptr(), error)
        })?;
        Ok(sampled)
    }
    /// The surface on a regular triangulation.
    pub fn remesh(&self, positions: &[f64], grid: i32, resolution: usize, host: &mut Host) -> Result<Mesh, Error> {
        expect_length(positions.len(), 3 * self.vertex_count, "positions")?;
        Mesh::made(host, |host, out, error| unsafe {
            obc_sphere_map_remesh(self.handle.as_ptr(), positions.as_ptr(), grid, resolution, host, out, error)
        })
    }
}

/// A geometry image: pixels x y z, row by row from the top. The layout is `OBC_SPHERE_MAP_OCTAHEDRON` or `OBC_SPHERE_MAP_CUBE`.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    layout: i32,
    resolution: usize,
    pixels: Vec<[f64; 3]>,
}

impl Image {
    /// Width and height.
    pub fn size_of(layout: i32, resolution: usize) -> Result<(usize, usize), Error> {
        let (mut width, mut height) = (0, 0);
        checked(|error| unsafe { obc_sphere_map_image_size(layout, resolution, &mut width, &mut height, error) })?;
        Ok((width, height))
    }
    pub fn new(layout: i32, resolution: usize, pixels: Vec<[f64; 3]>) -> Result<Image, Error> {
        let (width, height) = Image::size_of(layout, resolution)?;
        expect_length(pixels.len(), width * height, "pixels")?;
        Ok(Image { layout, resolution, pixels })
    }
    fn empty(layout: i32, resolution: usize) -> Result<Image, Error> {
        let (width, height) = Image::size_of(layout, resolution)?;
        Ok(Image { layout, resolution, pixels: vec![[0.0; 3]; width * height] })
    }
    /// Of positions of the vertices, or other vectors.
    pub fn of(locator: &Locator, positions: &[f64], layout: i32, resolution: usize, host: &mut Host) -> Result<Image, Error> {
        expect_length(positions.len(), 3 * locator.vertex_count, "positions")?;
        let mut image = Image::empty(layout, resolution)?;
        call(host, |host, error| unsafe {
            obc_sphere_map_image(locator.handle.as_ptr(), positions.as_ptr(), layout, resolution, host,
                                 image.pixels.as_mut_ptr() as *mut f64, error)
        })?;
        Ok(image)
    }
    /// Reads .pfm and .png.
    pub fn read(path: impl AsRef<Path>, host: &mut Host) -> Result<Image, Error> {
        let path = c_path(path.as_ref())?;
        let (mut layout, mut resolution) = (0, 0);
        call(host, |host, error| unsafe {
            obc_sphere_map_image_read(path.as_ptr(), host, &mut layout, &mut resolution, std::ptr::null_mut(), 0, error)
        })?;
        let mut image = Image::empty(layout, resolution)?;
        let capacity = 3 * image.pixels.len();
        call(host, |host, error| unsafe {
            obc_sphere_map_image_read(path.as_ptr(), host, &mut layout, &mut resolution, image.pixels.as_mut_ptr() as *mut f64,
                                      capacity, error)
        })?;
        Ok(image)
    }
    pub fn write(&self, path: impl AsRef<Path>, host: &mut Host) -> Result<(), Error> {
        let path = c_path(path.as_ref())?;
        call(host, |host, error| unsafe {
            obc_sphere_map_image_write(path.as_ptr(), self.pixels.as_ptr() as *const f64, self.layout, self.resolution, host, error)
        })
    }
    /// The closed surface back, and the largest distance between pixels that are one vertex.
    pub fn surface(&self, host: &mut Host) -> Result<(Mesh, f64), Error> {
        let mut gap = 0.0;
        let mesh = Mesh::made(host, |host, out, error| unsafe {
            obc_sphere_map_image_surface(self.pixels.as_ptr() as *const f64, self.layout, self.resolution, host, out, &mut gap, error)
        })?;
        Ok((mesh, gap))
    }
    pub fn layout(&self) -> i32 {
        self.layout
    }
    pub fn resolution(&self) -> usize {
        self.resolution
    }
    pub fn pixels(&self) -> &[[f64; 3]] {
        &self.pixels
    }
}

/// One triangulation of the sphere with the vertices of two maps, and where those of the second are in it (`u32::MAX`: in no triangle).
pub fn overlay(first: Surface, first_directions: &[f64], second: Surface, second_directions: &[f64],
               host: &mut Host) -> Result<(Mesh, Vec<u32>), Error> {
    expect_length(first_directions.len(), 3 * first.vertex_count(), "first_directions")?;
    expect_length(second_directions.len(), 3 * second.vertex_count(), "second_directions")?;
    let mut found = vec![0; second.vertex_count()];
    let mesh = Mesh::made(host, |host, out, error| unsafe {
        obc_sphere_map_overlay(&first.c, first_directions.as_ptr(), &second.c, second_directions.as_ptr(), host, out,
                               found.as_mut_ptr(), error)
    })?;
    Ok((mesh, found))
}

/// The matrix, by rows, that takes directions nearest to others.
pub fn best_rotation(from: &[[f64; 3]], to: &[[f64; 3]]) -> Result<[f64; 9], Error> {
    expect_length(to.len(), from.len(), "to")?;
    let mut rotation = [0.0; 9];
    checked(|error| unsafe {
        obc_sphere_map_best_rotation(from.as_ptr() as *const f64, to.as_ptr() as *const f64, from.len(), rotation.as_mut_ptr(),
                                     error)
    })?;
    Ok(rotation)
}

handle!(/// A smooth bijection of the sphere that carries landmarks onto landmarks.
    Warp, obc_sphere_map_warp, obc_sphere_map_warp_destroy);
// Used by any number of threads at once, as the header says.
unsafe impl Send for Warp {}
unsafe impl Sync for Warp {}

impl Warp {
    pub fn new(from: &[[f64; 3]], to: &[[f64; 3]], host: &mut Host) -> Result<Warp, Error> {
        expect_length(to.len(), from.len(), "to")?;
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe {
            obc_sphere_map_warp_create(from.as_ptr() as *const f64, to.as_ptr() as *const f64, from.len(), host, &mut out, error)
        })?;
        Ok(Warp::own(out))
    }
    /// Where each direction goes, or comes from.
    pub fn apply(&self, directions: &[[f64; 3]], backward: bool, host: &mut Host) -> Result<Vec<[f64; 3]>, Error> {
        let mut moved = vec![[0.0; 3]; directions.len()];
        call(host, |host, error| unsafe {
            obc_sphere_map_warp_apply(self.as_ptr(), directions.as_ptr() as *const f64, directions.len(), i32::from(backward),
                                      host, moved.as_mut_ptr() as *mut f64, error)
        })?;
        Ok(moved)
    }
}
