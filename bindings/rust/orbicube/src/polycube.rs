//! Polycubes of closed surfaces, and certified maps to them.
//!
//! ```
//! use orbicube::{mesh::Mesh, polycube::Polycube, Host};
//! let cube = Mesh::make("cube", 300, 0, &mut Host::new())?;
//! let map = Polycube::compute(cube.surface(), &Default::default(), &mut Host::new())?;
//! assert_eq!((map.corner_count(), map.patch_count()), (8, 6));
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{call, checked, expect_length, Error, Host};
use crate::mesh::Surface;
use crate::sys::base::{obc_error, obc_host};
use crate::sys::polycube::*;

filled!(/// Options, with their defaults.
    Options, obc_polycube_options, obc_polycube_options_init);
filled!(/// Options of the best proportions.
    DomainOptions, obc_polycube_domain_options, obc_polycube_domain_options_init);
filled!(/// Options of the best corners.
    CornerOptions, obc_polycube_corner_options, obc_polycube_corner_options_init);
filled!(/// How fine quads are.
    QuadsOptions, obc_polycube_quads_options, obc_polycube_quads_options_init);
sized!(/// What the best proportions are like.
    DomainReport, obc_polycube_domain_report);
sized!(/// What the best corners are like.
    CornerReport, obc_polycube_corner_report);

handle!(/// A certified map.
    Polycube, obc_polycube, obc_polycube_destroy);
// Read by several threads at once, as the header says.
unsafe impl Send for Polycube {}
unsafe impl Sync for Polycube {}

/// Of each triangle: its direction (0 to 5 for +x, -x, +y, -y, +z, -z), its patch, the surface's triangle.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OfTriangles {
    pub labels: Vec<u8>,
    pub patches: Vec<u32>,
    pub sources: Vec<u32>,
}

/// A mesh of quads on the surface, and the same vertices on the polycube.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Quads {
    pub positions: Vec<f64>,
    pub polycube: Vec<f64>,
    pub corners: Vec<[u32; 4]>,
    pub patches: Vec<u32>,
}

impl Polycube {
    fn made(host: &mut Host, f: impl FnOnce(*const obc_host, *mut *mut obc_polycube, *mut obc_error) -> i32) -> Result<Polycube, Error> {
        let mut out = std::ptr::null_mut();
        call(host, |host, error| f(host, &mut out, error))?;
        Ok(Polycube::own(out))
    }
    pub fn compute(surface: Surface, options: &Options, host: &mut Host) -> Result<Polycube, Error> {
        Polycube::made(host, |host, out, error| unsafe { obc_polycube_compute(&surface.c, &options.0, host, out, error) })
    }
    /// Maps a surface to the given polycube, which is stretched to its box.
    pub fn compute_on(surface: Surface, polycube: Surface, host: &mut Host) -> Result<Polycube, Error> {
        Polycube::made(host, |host, out, error| unsafe {
            obc_polycube_compute_on(&surface.c, &polycube.c, std::ptr::null(), host, out, error)
        })
    }
    /// A map made elsewhere; an error, with the reason, for what is none.
    pub fn certify(surface: Surface, polycube: &[f64], host: &mut Host) -> Result<Polycube, Error> {
        expect_length(polycube.len(), 3 * surface.vertex_count(), "polycube")?;
        Polycube::made(host, |host, out, error| unsafe {
            obc_polycube_create(&surface.c, polycube.as_ptr(), host, std::ptr::null_mut(), out, error)
        })
    }
    /// One polycube for several shapes, and the number of the shape that it was made for.
    pub fn compute_common(surfaces: &[Surface], options: &Options, domain: &DomainOptions,
                          host: &mut Host) -> Result<(Vec<Polycube>, usize), Error> {
        let views: Vec<_> = surfaces.iter().map(|surface| surface.c).collect();
        let (mut out, mut made_for) = (vec![std::ptr::null_mut(); views.len()], 0);
        call(host, |host, error| unsafe {
            obc_polycube_compute_common(views.as_ptr(), views.len(), &options.0, &domain.0, host, &mut made_for,
                                        out.as_mut_ptr(), error)
        })?;
        Ok((out.into_iter().map(Polycube::own).collect(), made_for))
    }
    /// The best distances between the planes.
    pub fn optimize_domain(&self, options: &DomainOptions, host: &mut Host) -> Result<(Polycube, DomainReport), Error> {
        let mut report = DomainReport::default();
        let map = Polycube::made(host, |host, out, error| unsafe {
            obc_polycube_optimize_domain(self.as_ptr(), &options.0, host, &mut report.0, out, error)
        })?;
        Ok((map, report))
    }
    /// Better places of the corners on the surface.
    pub fn optimize_corners(&self, options: &CornerOptions, host: &mut Host) -> Result<(Polycube, CornerReport), Error> {
        let mut report = CornerReport::default();
        let map = Polycube::made(host, |host, out, error| unsafe {
            obc_polycube_optimize_corners(self.as_ptr(), &options.0, host, &mut report.0, out, error)
        })?;
        Ok((map, report))
    }
    pub fn vertex_count(&self) -> usize {
        unsafe { obc_polycube_vertex_count(self.as_ptr()) }
    }
    pub fn triangle_count(&self) -> usize {
        unsafe { obc_polycube_triangle_count(self.as_ptr()) }
    }
    pub fn corner_count(&self) -> usize {
        unsafe { obc_polycube_corner_count(self.as_ptr()) }
    }
    pub fn patch_count(&self) -> usize {
        unsafe { obc_polycube_patch_count(self.as_ptr()) }
    }
    /// Positions in space and on the polycube, x y z a vertex, and triangles.
    pub fn arrays(&self) -> (Vec<f64>, Vec<f64>, Vec<u32>) {
        let n = 3 * self.vertex_count();
        let (mut positions, mut polycube, mut triangles) = (vec![0.0; n], vec![0.0; n], vec![0; 3 * self.triangle_count()]);
        let status = unsafe {
            obc_polycube_copy(self.as_ptr(), positions.as_mut_ptr(), polycube.as_mut_ptr(), triangles.as_mut_ptr(), std::ptr::null_mut())
        };
        assert_eq!(status, 0, "a map can be copied");
        (positions, polycube, triangles)
    }
    pub fn of_triangles(&self) -> Result<OfTriangles, Error> {
        let n = self.triangle_count();
        let mut out = OfTriangles { labels: vec![0; n], patches: vec![0; n], sources: vec![0; n] };
        checked(|error| unsafe {
            obc_polycube_copy_triangles(self.as_ptr(), out.labels.as_mut_ptr(), out.patches.as_mut_ptr(), out.sources.as_mut_ptr(), error)
        })?;
        Ok(out)
    }
    /// Of the optimisation that it comes from; they never rise.
    pub fn energies(&self) -> Result<Vec<f64>, Error> {
        let mut out = vec![0.0; unsafe { obc_polycube_energy_count(self.as_ptr()) }];
        checked(|error| unsafe { obc_polycube_copy_energies(self.as_ptr(), out.as_mut_ptr(), error) })?;
        Ok(out)
    }
    pub fn quads(&self, options: &QuadsOptions, host: &mut Host) -> Result<Quads, Error> {
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe { obc_polycube_quads_create(self.as_ptr(), &options.0, host, &mut out, error) })?;
        let handle = QuadsHandle::own(out);
        let out = handle.as_ptr();
        let (n, m) = unsafe { (obc_polycube_quads_vertex_count(out), obc_polycube_quads_quad_count(out)) };
        let mut quads = Quads { positions: vec![0.0; 3 * n], polycube: vec![0.0; 3 * n], corners: vec![[0; 4]; m], patches: vec![0; m] };
        checked(|error| unsafe {
            obc_polycube_quads_copy(out, quads.positions.as_mut_ptr(), quads.polycube.as_mut_ptr(),
                                    quads.corners.as_mut_ptr() as *mut u32, quads.patches.as_mut_ptr(), error)
        })?;
        Ok(quads)
    }
}

handle!(QuadsHandle, obc_polycube_quads, obc_polycube_quads_destroy);
