//! Triangle surfaces and meshes of cells: files, topology, searches, exact signs.
//!
//! ```
//! use orbicube::{mesh, Host};
//! let torus = mesh::Mesh::make("torus", 2000, 0, &mut Host::new())?;
//! assert_eq!(mesh::topology(torus.surface(), &mut Host::new())?.genus, 1);
//! # Ok::<(), orbicube::Error>(())
//! ```

use std::marker::PhantomData;
use std::path::Path;
use std::slice;

use crate::call::{c_path, c_string, call, checked, pointer, rows, text, Error, Host};
use crate::sys::mesh::*;

/// A surface that lies elsewhere.
#[derive(Clone, Copy)]
pub struct Surface<'a> {
    pub(crate) c: obc_surface,
    marker: PhantomData<&'a [f64]>,
}

// Slices that are only read.
unsafe impl Send for Surface<'_> {}
unsafe impl Sync for Surface<'_> {}

impl<'a> Surface<'a> {
    /// Positions x y z a vertex, triangles of three vertices, counter-clockwise seen from outside.
    pub fn new(positions: &'a [f64], triangles: &'a [u32]) -> Result<Surface<'a>, Error> {
        let c = obc_surface {
            positions: pointer(positions),
            vertex_count: rows(positions.len(), 3, "positions")?,
            triangles: pointer(triangles),
            triangle_count: rows(triangles.len(), 3, "triangles")?,
        };
        Ok(Surface { c, marker: PhantomData })
    }
    pub fn vertex_count(&self) -> usize {
        self.c.vertex_count
    }
    pub fn triangle_count(&self) -> usize {
        self.c.triangle_count
    }
    pub fn positions(&self) -> &'a [f64] {
        view(self.c.positions, 3 * self.c.vertex_count)
    }
    pub fn triangles(&self) -> &'a [u32] {
        view(self.c.triangles, 3 * self.c.triangle_count)
    }
}

fn view<'a, T>(start: *const T, length: usize) -> &'a [T] {
    if length == 0 || start.is_null() {
        &[]
    } else {
        unsafe { slice::from_raw_parts(start, length) }
    }
}

filled!(/// Options of reading, with their defaults.
    ReadOptions, obc_mesh_read_options, obc_mesh_read_options_init);
filled!(/// Options of writing, with their defaults.
    WriteOptions, obc_mesh_write_options, obc_mesh_write_options_init);
filled!(/// What kind of surface it is.
    Topology, obc_mesh_topology_report, obc_mesh_topology_report_init);
filled!(/// How well shaped tetrahedra are.
    TetrahedronQuality, obc_mesh_tetrahedron_quality_report, obc_mesh_tetrahedron_quality_report_init);
filled!(/// Distances between two surfaces.
    Distance, obc_mesh_distance, obc_mesh_distance_init);
filled!(/// What was turned.
    Oriented, obc_mesh_orient_report, obc_mesh_orient_report_init);

handle!(/// A mesh in the library's memory.
    Mesh, obc_mesh, obc_mesh_destroy);
// Read by several threads at once, as the header says.
unsafe impl Send for Mesh {}
unsafe impl Sync for Mesh {}

impl Mesh {
    pub(crate) fn made(host: &mut Host, f: impl FnOnce(*const crate::sys::base::obc_host, *mut *mut obc_mesh,
                                                       *mut crate::sys::base::obc_error) -> i32) -> Result<Mesh, Error> {
        let mut out = std::ptr::null_mut();
        call(host, |host, error| f(host, &mut out, error))?;
        Ok(Mesh::own(out))
    }
    /// Copies of arrays; cells may be empty.
    pub fn new(positions: &[f64], triangles: &[u32], tetrahedra: &[u32], hexahedra: &[u32]) -> Result<Mesh, Error> {
        let mut cells: obc_mesh_cells = unsafe { std::mem::zeroed() };
        unsafe { obc_mesh_cells_init(&mut cells, std::mem::size_of::<obc_mesh_cells>()) };
        cells.positions = pointer(positions);
        cells.vertex_count = rows(positions.len(), 3, "positions")?;
        cells.triangles = pointer(triangles);
        cells.triangle_count = rows(triangles.len(), 3, "triangles")?;
        cells.tetrahedra = pointer(tetrahedra);
        cells.tetrahedron_count = rows(tetrahedra.len(), 4, "tetrahedra")?;
        cells.hexahedra = pointer(hexahedra);
        cells.hexahedron_count = rows(hexahedra.len(), 8, "hexahedra")?;
        Mesh::made(&mut Host::new(), |host, out, error| unsafe { obc_mesh_create(&cells, host, out, error) })
    }
    /// A copy with these region numbers, one for each triangle, tetrahedron and hexahedron; of each kind none if the slice is empty.
    pub fn with_regions(&self, triangles: &[i32], tetrahedra: &[i32], hexahedra: &[i32]) -> Result<Mesh, Error> {
        let (four, eight) = (self.tetrahedra(), self.hexahedra());
        let mut cells: obc_mesh_cells = unsafe { std::mem::zeroed() };
        unsafe { obc_mesh_cells_init(&mut cells, std::mem::size_of::<obc_mesh_cells>()) };
        cells.positions = pointer(self.positions());
        cells.vertex_count = self.positions().len() / 3;
        cells.triangles = pointer(self.triangles());
        cells.triangle_count = self.triangles().len() / 3;
        cells.tetrahedra = pointer(&four);
        cells.tetrahedron_count = four.len() / 4;
        cells.hexahedra = pointer(&eight);
        cells.hexahedron_count = eight.len() / 8;
        for (regions, count, what) in [(triangles, cells.triangle_count, "triangles"), (tetrahedra, cells.tetrahedron_count, "tetrahedra"),
                                       (hexahedra, cells.hexahedron_count, "hexahedra")] {
            if !regions.is_empty() && regions.len() != count {
                return Err(Error::invalid(format!("{} region numbers of {count} {what}", regions.len())));
            }
        }
        cells.triangle_regions = pointer(triangles);
        cells.tetrahedron_regions = pointer(tetrahedra);
        cells.hexahedron_regions = pointer(hexahedra);
        Mesh::made(&mut Host::new(), |host, out, error| unsafe { obc_mesh_create(&cells, host, out, error) })
    }
    /// A closed surface by name, of about the given number of triangles.
    pub fn make(shape: &str, triangles: usize, seed: u64, host: &mut Host) -> Result<Mesh, Error> {
        let shape = c_string(shape)?;
        Mesh::made(host, |host, out, error| unsafe { obc_mesh_make(shape.as_ptr(), triangles, seed, host, out, error) })
    }
    /// Reads a file in the format of its ending; [`formats`] lists them.
    pub fn read(path: impl AsRef<Path>, options: &ReadOptions, host: &mut Host) -> Result<Mesh, Error> {
        let path = c_path(path.as_ref())?;
        Mesh::made(host, |host, out, error| unsafe { obc_mesh_read(path.as_ptr(), &options.0, host, out, error) })
    }
    /// The same from bytes of the format `OBC_MESH_PLY`, ...
    pub fn read_memory(bytes: &[u8], format: i32, options: &ReadOptions, host: &mut Host) -> Result<Mesh, Error> {
        Mesh::made(host, |host, out, error| unsafe {
            obc_mesh_read_memory(bytes.as_ptr() as *const _, bytes.len(), format, &options.0, host, out, error)
        })
    }
    pub fn write(&self, path: impl AsRef<Path>, options: &WriteOptions, host: &mut Host) -> Result<(), Error> {
        let path = c_path(path.as_ref())?;
        call(host, |host, error| unsafe { obc_mesh_write(path.as_ptr(), self.as_ptr(), &options.0, host, error) })
    }
    /// A view of the mesh's memory.
    pub fn surface(&self) -> Surface<'_> {
        let mut c: obc_surface = unsafe { std::mem::zeroed() };
        let status = unsafe { obc_mesh_surface(self.as_ptr(), &mut c, std::ptr::null_mut()) };
        assert_eq!(status, 0, "a mesh has a surface");
        Surface { c, marker: PhantomData }
    }
    pub fn positions(&self) -> &[f64] {
        self.surface().positions()
    }
    pub fn triangles(&self) -> &[u32] {
        self.surface().triangles()
    }
    /// A copy.
    pub fn tetrahedra(&self) -> Vec<u32> {
        let mut cells = vec![0; 4 * unsafe { obc_mesh_tetrahedron_count(self.as_ptr()) }];
        let none = std::ptr::null_mut();
        unsafe { obc_mesh_copy(self.as_ptr(), std::ptr::null_mut(), none, cells.as_mut_ptr(), none, std::ptr::null_mut()) };
        cells
    }
    /// A copy.
    pub fn hexahedra(&self) -> Vec<u32> {
        let mut cells = vec![0; 8 * unsafe { obc_mesh_hexahedron_count(self.as_ptr()) }];
        let none = std::ptr::null_mut();
        unsafe { obc_mesh_copy(self.as_ptr(), std::ptr::null_mut(), none, none, cells.as_mut_ptr(), std::ptr::null_mut()) };
        cells
    }
    /// The region number of each triangle, 0 for none, as a copy; empty if there are none.
    pub fn triangle_regions(&self) -> Vec<i32> {
        self.regions(OBC_MESH_TRIANGLE_REGIONS, unsafe { obc_mesh_triangle_count(self.as_ptr()) }, 0)
    }
    /// That of each tetrahedron.
    pub fn tetrahedron_regions(&self) -> Vec<i32> {
        self.regions(OBC_MESH_TETRAHEDRON_REGIONS, unsafe { obc_mesh_tetrahedron_count(self.as_ptr()) }, 1)
    }
    /// That of each hexahedron.
    pub fn hexahedron_regions(&self) -> Vec<i32> {
        self.regions(OBC_MESH_HEXAHEDRON_REGIONS, unsafe { obc_mesh_hexahedron_count(self.as_ptr()) }, 2)
    }
    fn regions(&self, kind: i32, count: usize, place: usize) -> Vec<i32> {
        if unsafe { obc_mesh_region_kinds(self.as_ptr()) } & kind as u32 == 0 {
            return Vec::new();
        }
        let mut numbers = vec![0; count];
        let mut to = [std::ptr::null_mut(); 3];
        to[place] = numbers.as_mut_ptr();
        unsafe { obc_mesh_copy_regions(self.as_ptr(), to[0], to[1], to[2], std::ptr::null_mut()) };
        numbers
    }
    /// Of the file that it was read from.
    pub fn format(&self) -> String {
        text(unsafe { obc_mesh_format(self.as_ptr()) })
    }
    /// Faces of more than three corners in the file.
    pub fn polygon_count(&self) -> usize {
        unsafe { obc_mesh_polygon_count(self.as_ptr()) }
    }
    /// Vertices that were welded to others in reading.
    pub fn welded_vertex_count(&self) -> usize {
        unsafe { obc_mesh_welded_vertex_count(self.as_ptr()) }
    }
    /// What was changed or left out in reading.
    pub fn notes(&self) -> Vec<String> {
        (0..).map(|i| unsafe { obc_mesh_note(self.as_ptr(), i) }).take_while(|note| !note.is_null()).map(text).collect()
    }
    /// An error, with the place, unless the cells fill a solid.
    pub fn check_cells(&self, host: &mut Host) -> Result<(), Error> {
        call(host, |host, error| unsafe { obc_mesh_check_cells(self.as_ptr(), host, error) })
    }
    /// The surface of the solid that the cells fill.
    pub fn boundary(&self, host: &mut Host) -> Result<Mesh, Error> {
        Mesh::made(host, |host, out, error| unsafe { obc_mesh_boundary(self.as_ptr(), host, out, error) })
    }
    pub fn tetrahedron_quality(&self, host: &mut Host) -> Result<TetrahedronQuality, Error> {
        let mut report = TetrahedronQuality::default();
        call(host, |host, error| unsafe { obc_mesh_tetrahedron_quality(self.as_ptr(), host, &mut report.0, error) })?;
        Ok(report)
    }
}

/// A file format. Polygons: of shared vertices, whose coordinates read back bit-identically.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Format {
    pub name: String,
    pub ending: String,
    pub polygons: bool,
    pub cells: bool,
    pub binary: bool,
    pub regions: bool,
}

/// The formats of [`Mesh::read`] and [`Mesh::write`], in the order of `OBC_MESH_...`.
pub fn formats() -> Vec<Format> {
    let name = |i| unsafe { obc_mesh_format_name(i) };
    (0..)
        .take_while(|&i| !name(i).is_null())
        .map(|i| {
            let held = unsafe { obc_mesh_format_contents(i) };
            let holds = |bit: i32| held & bit as u32 != 0;
            Format { name: text(name(i)), ending: text(unsafe { obc_mesh_format_ending(i) }), polygons: holds(OBC_MESH_HOLDS_POLYGONS),
                     cells: holds(OBC_MESH_HOLDS_CELLS), binary: holds(OBC_MESH_HOLDS_BINARY),
                     regions: holds(OBC_MESH_HOLDS_REGIONS) }
        })
        .collect()
}

/// What [`Mesh::make`] knows.
pub fn shape_names() -> Vec<String> {
    (0..).map(|i| unsafe { obc_mesh_shape_name(i) }).take_while(|name| !name.is_null()).map(text).collect()
}

pub fn topology(surface: Surface, host: &mut Host) -> Result<Topology, Error> {
    let mut report = Topology::default();
    call(host, |host, error| unsafe { obc_mesh_topology(&surface.c, host, &mut report.0, error) })?;
    Ok(report)
}

/// Unit normals of the vertices, the triangles' weighted by their angles.
pub fn vertex_normals(surface: Surface, host: &mut Host) -> Result<Vec<f64>, Error> {
    let mut normals = vec![0.0; 3 * surface.vertex_count()];
    call(host, |host, error| unsafe { obc_mesh_vertex_normals(&surface.c, host, normals.as_mut_ptr(), error) })?;
    Ok(normals)
}

/// A third of the area of its triangles for each vertex: the usual weights of a fit by harmonics.
pub fn vertex_areas(surface: Surface, host: &mut Host) -> Result<Vec<f64>, Error> {
    let mut areas = vec![0.0; surface.vertex_count()];
    call(host, |host, error| unsafe { obc_mesh_vertex_areas(&surface.c, host, areas.as_mut_ptr(), error) })?;
    Ok(areas)
}

/// Distances from points of one surface to the other, and back.
pub fn surface_distance(first: Surface, second: Surface, host: &mut Host) -> Result<Distance, Error> {
    let mut distance = Distance::default();
    call(host, |host, error| unsafe {
        obc_mesh_surface_distance(&first.c, &second.c, host, &mut distance.0, error)
    })?;
    Ok(distance)
}

/// The mean distance from points to the nearest of the others, the greater of both ways: the reconstruction error e(A, B).
pub fn mean_distance(a: &[[f64; 3]], b: &[[f64; 3]], host: &mut Host) -> Result<f64, Error> {
    let mut distance = 0.0;
    call(host, |host, error| unsafe {
        obc_mesh_mean_distance(a.as_ptr() as *const f64, a.len(), b.as_ptr() as *const f64, b.len(), host, &mut distance, error)
    })?;
    Ok(distance)
}

/// An error, with the place, unless the surface is what sphere maps need.
pub fn check_closed_genus_zero(surface: Surface, host: &mut Host) -> Result<(), Error> {
    call(host, |host, error| unsafe { obc_mesh_check_closed_genus_zero(&surface.c, host, error) })
}

/// Turns triangles in place so that neighbors agree and a closed surface is outward-oriented.
pub fn orient(positions: &[f64], triangles: &mut [u32], host: &mut Host) -> Result<Oriented, Error> {
    let (vertices, count) = (rows(positions.len(), 3, "positions")?, rows(triangles.len(), 3, "triangles")?);
    let mut report = Oriented::default();
    call(host, |host, error| unsafe {
        obc_mesh_orient(positions.as_ptr(), vertices, triangles.as_mut_ptr(), count, host, &mut report.0, error)
    })?;
    Ok(report)
}

/// The first pairs of triangles that meet where they should not.
pub fn intersections(surface: Surface, capacity: usize, host: &mut Host) -> Result<Vec<[u32; 2]>, Error> {
    let (mut pairs, mut count) = (vec![[0; 2]; capacity], 0);
    call(host, |host, error| unsafe {
        obc_mesh_intersections(&surface.c, host, pairs.as_mut_ptr() as *mut u32, capacity, &mut count, error)
    })?;
    pairs.truncate(count);
    Ok(pairs)
}

handle!(/// A surface made ready for searching.
    Search, obc_mesh_search, obc_mesh_search_destroy);
// Read by several threads at once, as the header says.
unsafe impl Send for Search {}
unsafe impl Sync for Search {}

/// Of the nearest point of the surface: its triangle, weights at the corners, position and distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    pub triangle: u32,
    pub weights: [f64; 3],
    pub position: [f64; 3],
    pub distance: f64,
}

impl Search {
    pub fn new(surface: Surface, host: &mut Host) -> Result<Search, Error> {
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe { obc_mesh_search_create(&surface.c, host, &mut out, error) })?;
        Ok(Search::own(out))
    }
    /// The vertex nearest to each point.
    pub fn vertices(&self, points: &[[f64; 3]]) -> Result<Vec<u32>, Error> {
        let mut found = vec![0; points.len()];
        checked(|error| unsafe {
            obc_mesh_search_vertices(self.as_ptr(), points.as_ptr() as *const f64, points.len(), found.as_mut_ptr(), error)
        })?;
        Ok(found)
    }
    pub fn surface(&self, points: &[[f64; 3]]) -> Result<Vec<Nearest>, Error> {
        let n = points.len();
        let (mut triangles, mut weights) = (vec![0; n], vec![[0.0; 3]; n]);
        let (mut positions, mut distances) = (vec![[0.0; 3]; n], vec![0.0; n]);
        checked(|error| unsafe {
            obc_mesh_search_surface(self.as_ptr(), points.as_ptr() as *const f64, n, triangles.as_mut_ptr(),
                                    weights.as_mut_ptr() as *mut f64, positions.as_mut_ptr() as *mut f64,
                                    distances.as_mut_ptr(), error)
        })?;
        Ok((0..n)
            .map(|i| Nearest { triangle: triangles[i], weights: weights[i], position: positions[i], distance: distances[i] })
            .collect())
    }
}

/// Exact sign of (b - a) x (c - a); `None` for what is not finite.
pub fn orientation_2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<i32> {
    sign(unsafe { obc_mesh_orientation_2d(a.as_ptr(), b.as_ptr(), c.as_ptr()) })
}

/// Exact sign of det[b - a, c - a, d - a].
pub fn orientation_3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Option<i32> {
    sign(unsafe { obc_mesh_orientation_3d(a.as_ptr(), b.as_ptr(), c.as_ptr(), d.as_ptr()) })
}

/// Exact sign of det[p, q, r].
pub fn orientation_from_origin(p: [f64; 3], q: [f64; 3], r: [f64; 3]) -> Option<i32> {
    sign(unsafe { obc_mesh_orientation_from_origin(p.as_ptr(), q.as_ptr(), r.as_ptr()) })
}

fn sign(answer: i32) -> Option<i32> {
    if answer == 2 { None } else { Some(answer) }
}

/// For each vertex the lowest one at its very position.
pub fn first_at_same_position(positions: &[f64], host: &mut Host) -> Result<Vec<u32>, Error> {
    let mut first = vec![0; rows(positions.len(), 3, "positions")?];
    call(host, |host, error| unsafe {
        obc_mesh_first_at_same_position(positions.as_ptr(), first.len(), host, first.as_mut_ptr(), error)
    })?;
    Ok(first)
}
