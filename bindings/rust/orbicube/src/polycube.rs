//! Polycubes of closed surfaces, and certified maps to them.
//!
//! ```
//! use orbicube::{mesh::Mesh, polycube::Polycube, Host};
//! let cube = Mesh::make("cube", 300, 0, &mut Host::new())?;
//! let map = Polycube::compute(cube.surface(), &Default::default(), &mut Host::new())?;
//! assert_eq!((map.corner_count(), map.patch_count()), (8, 6));
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{call, checked, expect_length, pointer, Error, Host};
use crate::mesh::Surface;
use crate::sys::base::{obc_error, obc_host};
use crate::sys::polycube::*;

filled!(/// Options, with their defaults.
    Options, obc_polycube_options, obc_polycube_options_init);
filled!(/// Options of the best proportions.
    DomainOptions, obc_polycube_domain_options, obc_polycube_domain_options_init);
filled!(/// Options of the best corners.
    CornerOptions, obc_polycube_corner_options, obc_polycube_corner_options_init);
filled!(/// Size and padding of an atlas.
    AtlasOptions, obc_polycube_atlas_options, obc_polycube_atlas_options_init);
filled!(/// How fine quads are.
    QuadsOptions, obc_polycube_quads_options, obc_polycube_quads_options_init);
sized!(/// What was reached with features.
    FeatureReport, obc_polycube_feature_report);
sized!(/// What the best proportions are like.
    DomainReport, obc_polycube_domain_report);
sized!(/// What the best corners are like.
    CornerReport, obc_polycube_corner_report);

handle!(/// A certified map.
    Polycube, obc_polycube, obc_polycube_destroy);
// Read by several threads at once, as the header says.
unsafe impl Send for Polycube {}
unsafe impl Sync for Polycube {}

handle!(/// A texture atlas: the patches of a polycube packed into a square.
    Atlas, obc_polycube_atlas, obc_polycube_atlas_destroy);
unsafe impl Send for Atlas {}
unsafe impl Sync for Atlas {}

/// What each texel of an atlas shows, row by row from the top.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Texels {
    /// Of the map; `u32::MAX` for none.
    pub triangles: Vec<u32>,
    /// Of the corners of the triangle.
    pub weights: Vec<[f64; 3]>,
    /// Whether the triangle has the middle of the texel; others show the nearest texel in a patch.
    pub covered: Vec<bool>,
}

impl Atlas {
    /// Texels along each side.
    pub fn size(&self) -> usize {
        unsafe { obc_polycube_atlas_size(self.as_ptr()) as usize }
    }
    /// u and v of the three corners of each triangle, 0 to 1, from the top left.
    pub fn coordinates(&self) -> Result<Vec<[[f64; 2]; 3]>, Error> {
        let mut out = vec![[[0.0; 2]; 3]; unsafe { obc_polycube_atlas_triangle_count(self.as_ptr()) }];
        checked(|error| unsafe {
            obc_polycube_atlas_copy(self.as_ptr(), out.as_mut_ptr() as *mut f64, std::ptr::null_mut(), std::ptr::null_mut(), error)
        })?;
        Ok(out)
    }
    /// Texels along a unit of the polycube, and the fraction of the square in patches.
    pub fn scale_and_coverage(&self) -> Result<(f64, f64), Error> {
        let (mut scale, mut coverage) = (0.0, 0.0);
        checked(|error| unsafe { obc_polycube_atlas_copy(self.as_ptr(), std::ptr::null_mut(), &mut scale, &mut coverage, error) })?;
        Ok((scale, coverage))
    }
    pub fn sample(&self, host: &mut Host) -> Result<Texels, Error> {
        let count = self.size() * self.size();
        let (mut triangles, mut weights, mut covered) = (vec![0u32; count], vec![[0.0; 3]; count], vec![0u8; count]);
        call(host, |host, error| unsafe {
            obc_polycube_atlas_sample(self.as_ptr(), host, triangles.as_mut_ptr(), weights.as_mut_ptr() as *mut f64,
                                      covered.as_mut_ptr(), error)
        })?;
        Ok(Texels { triangles, weights, covered: covered.iter().map(|&flag| flag != 0).collect() })
    }
}

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
    /// Of each vertex the triangle of the map that it is in, and its weights there.
    pub triangles: Vec<u32>,
    pub weights: Vec<[f64; 3]>,
}

/// Where each vertex of a map comes from: vertices of one triangle of the surface (`u32::MAX` where fewer are needed), weights.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sources {
    pub corners: Vec<[u32; 3]>,
    pub weights: Vec<[f64; 3]>,
}

/// Where a corner of a given polycube is to be on the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    Vertex(u32),
    /// At the nearest point of the surface.
    Near([f64; 3]),
}

/// What must be mapped where. Weights are those of squared distances; 0 means that it must be met exactly.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Features {
    /// Vertices of the map, their target positions on the polycube, and weights.
    pub points: Vec<(u32, [f64; 3], f64)>,
    pub curves: Vec<Curve>,
    /// Minimum dihedral angle, in degrees, of surface edges that are aligned to nearby polycube edges; 0: none.
    pub feature_angle: f64,
}

/// Vertices along a curve of the surface, and a line along an axis on the polycube that they are to be on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    pub vertices: Vec<u32>,
    pub line: [[f64; 3]; 2],
    pub weight: f64,
}

/// Corners, straight edges and patches of a polycube, without its triangles; `obc_polycube_graph_...` in C describes each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Graph {
    pub corner_positions: Vec<[f64; 3]>,
    pub corner_vertices: Vec<u32>,
    pub edge_corners: Vec<[u32; 2]>,
    /// On the left and on the right.
    pub edge_patches: Vec<[u32; 2]>,
    pub edge_convex: Vec<bool>,
    pub patch_labels: Vec<u8>,
    pub patch_coordinates: Vec<f64>,
    /// Of each patch its loops, the first around it, each the darts of its edges.
    pub patch_loops: Vec<Vec<Vec<u32>>>,
    /// Of each patch those that share an edge with it.
    pub neighbors: Vec<Vec<u32>>,
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
    pub fn map_to_domain(surface: Surface, polycube: Surface, host: &mut Host) -> Result<Polycube, Error> {
        Polycube::made(host, |host, out, error| unsafe {
            obc_polycube_map_to_domain(&surface.c, &polycube.c, std::ptr::null(), host, out, error)
        })
    }
    /// The same with positions of corners, each a vertex of the given polycube.
    pub fn map_to_domain_with_constraints(surface: Surface, polycube: Surface, constraints: &[(u32, Place)], host: &mut Host) -> Result<Polycube, Error> {
        let corners: Vec<u32> = constraints.iter().map(|place| place.0).collect();
        let (vertices, points): (Vec<u32>, Vec<[f64; 3]>) = constraints.iter().map(|place| match place.1 {
            Place::Vertex(vertex) => (vertex, [0.0; 3]),
            Place::Near(point) => (u32::MAX, point),
        }).unzip();
        let c = obc_polycube_constraints {
            corners: pointer(&corners),
            vertices: pointer(&vertices),
            points: pointer(&points) as *const f64,
            count: corners.len(),
        };
        Polycube::made(host, |host, out, error| unsafe {
            obc_polycube_map_to_domain(&surface.c, &polycube.c, &c, host, out, error)
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
        let (mut out, mut constructed_from) = (vec![std::ptr::null_mut(); views.len()], 0);
        call(host, |host, error| unsafe {
            obc_polycube_compute_common(views.as_ptr(), views.len(), &options.0, &domain.0, host, &mut constructed_from,
                                        out.as_mut_ptr(), error)
        })?;
        Ok((out.into_iter().map(Polycube::own).collect(), constructed_from))
    }
    /// The proportions with the minimum sum of energies of maps to one polycube.
    pub fn optimize_common_domain(maps: &[&Polycube], options: &DomainOptions, host: &mut Host) -> Result<Vec<Polycube>, Error> {
        let given: Vec<_> = maps.iter().map(|map| map.as_ptr() as *const obc_polycube).collect();
        let mut out = vec![std::ptr::null_mut(); given.len()];
        call(host, |host, error| unsafe {
            obc_polycube_optimize_common_domain(given.as_ptr(), given.len(), &options.0, host, out.as_mut_ptr(), error)
        })?;
        Ok(out.into_iter().map(Polycube::own).collect())
    }
    /// The same polycube with features at their target positions; an error says what cannot be met.
    pub fn align_features(&self, features: &Features, host: &mut Host) -> Result<(Polycube, FeatureReport), Error> {
        let mut c: obc_polycube_feature_options = unsafe { std::mem::zeroed() };
        unsafe { obc_polycube_feature_options_init(&mut c, std::mem::size_of::<obc_polycube_feature_options>()) };
        let points: Vec<u32> = features.points.iter().map(|point| point.0).collect();
        let targets: Vec<[f64; 3]> = features.points.iter().map(|point| point.1).collect();
        let point_weights: Vec<f64> = features.points.iter().map(|point| point.2).collect();
        c.point_count = points.len();
        c.points = pointer(&points);
        c.targets = pointer(&targets) as *const f64;
        c.point_weights = pointer(&point_weights);
        let (mut starts, mut vertices) = (vec![0], vec![]);
        for curve in &features.curves {
            vertices.extend_from_slice(&curve.vertices);
            starts.push(u32::try_from(vertices.len()).map_err(|_| Error::invalid("curves: too many vertices"))?);
        }
        let lines: Vec<[[f64; 3]; 2]> = features.curves.iter().map(|curve| curve.line).collect();
        let curve_weights: Vec<f64> = features.curves.iter().map(|curve| curve.weight).collect();
        c.curve_count = features.curves.len();
        c.curve_starts = starts.as_ptr();
        c.curve_vertices = vertices.as_ptr(); // not NULL, even of nothing
        c.curve_lines = pointer(&lines) as *const f64;
        c.curve_weights = pointer(&curve_weights);
        c.feature_angle = features.feature_angle;
        let mut report = FeatureReport::default();
        let map = Polycube::made(host, |host, out, error| unsafe {
            obc_polycube_align_features(self.as_ptr(), &c, host, &mut report.0, out, error)
        })?;
        Ok((map, report))
    }
    /// The best distances between the planes.
    pub fn optimize_domain(&self, options: &DomainOptions, host: &mut Host) -> Result<(Polycube, DomainReport), Error> {
        let mut report = DomainReport::default();
        let map = Polycube::made(host, |host, out, error| unsafe {
            obc_polycube_optimize_domain(self.as_ptr(), &options.0, host, &mut report.0, out, error)
        })?;
        Ok((map, report))
    }
    /// Better positions of the corners on the surface.
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
    /// What found the map: `OBC_POLYCUBE_LABELS`, `OBC_POLYCUBE_VOXELS` or
    /// `OBC_POLYCUBE_DISSERTATION`; none for a map made elsewhere.
    pub fn construction(&self) -> Option<i32> {
        let found = unsafe { obc_polycube_construction(self.as_ptr()) };
        if found < 0 { None } else { Some(found) }
    }
    pub fn sources(&self) -> Result<Sources, Error> {
        let n = self.vertex_count();
        let mut out = Sources { corners: vec![[0; 3]; n], weights: vec![[0.0; 3]; n] };
        checked(|error| unsafe {
            obc_polycube_copy_sources(self.as_ptr(), out.corners.as_mut_ptr() as *mut u32, out.weights.as_mut_ptr() as *mut f64, error)
        })?;
        Ok(out)
    }
    pub fn graph(&self, host: &mut Host) -> Result<Graph, Error> {
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe { obc_polycube_graph_create(self.as_ptr(), host, &mut out, error) })?;
        let handle = GraphHandle::own(out);
        let out = handle.as_ptr();
        let (corners, edges, patches, loops, links) = unsafe {
            (obc_polycube_graph_corner_count(out), obc_polycube_graph_edge_count(out), obc_polycube_graph_patch_count(out),
             obc_polycube_graph_loop_count(out), obc_polycube_graph_link_count(out))
        };
        let mut graph = Graph {
            corner_positions: vec![[0.0; 3]; corners],
            corner_vertices: vec![0; corners],
            edge_corners: vec![[0; 2]; edges],
            edge_patches: vec![[0; 2]; edges],
            patch_labels: vec![0; patches],
            patch_coordinates: vec![0.0; patches],
            ..Graph::default()
        };
        let (mut convex, mut loops_of, mut begin, mut darts) = (vec![0u8; edges], vec![0u32; patches + 1], vec![0u32; loops + 1], vec![0u32; 2 * edges]);
        let (mut dual, mut neighbors) = (vec![0u32; patches + 1], vec![0u32; links]);
        checked(|error| unsafe {
            obc_polycube_graph_copy_corners(out, graph.corner_positions.as_mut_ptr() as *mut f64, graph.corner_vertices.as_mut_ptr(), error)
        })?;
        checked(|error| unsafe {
            obc_polycube_graph_copy_edges(out, graph.edge_corners.as_mut_ptr() as *mut u32, graph.edge_patches.as_mut_ptr() as *mut u32,
                                          convex.as_mut_ptr(), error)
        })?;
        checked(|error| unsafe {
            obc_polycube_graph_copy_patches(out, graph.patch_labels.as_mut_ptr(), graph.patch_coordinates.as_mut_ptr(),
                                            loops_of.as_mut_ptr(), error)
        })?;
        checked(|error| unsafe { obc_polycube_graph_copy_loops(out, begin.as_mut_ptr(), darts.as_mut_ptr(), error) })?;
        checked(|error| unsafe { obc_polycube_graph_copy_dual(out, dual.as_mut_ptr(), neighbors.as_mut_ptr(), error) })?;
        graph.edge_convex = convex.iter().map(|&flag| flag != 0).collect();
        let loops = parts(&begin, &darts);
        graph.patch_loops = loops_of.windows(2).map(|ends| loops[ends[0] as usize..ends[1] as usize].to_vec()).collect();
        graph.neighbors = parts(&dual, &neighbors);
        Ok(graph)
    }
    /// Of the optimization that it comes from; they never rise.
    pub fn energies(&self) -> Result<Vec<f64>, Error> {
        let mut out = vec![0.0; unsafe { obc_polycube_energy_count(self.as_ptr()) }];
        checked(|error| unsafe { obc_polycube_copy_energies(self.as_ptr(), out.as_mut_ptr(), error) })?;
        Ok(out)
    }
    /// The patches packed into a square, for textures; it does not need the map any more.
    pub fn atlas(&self, options: &AtlasOptions, host: &mut Host) -> Result<Atlas, Error> {
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe { obc_polycube_atlas_create(self.as_ptr(), &options.0, host, &mut out, error) })?;
        Ok(Atlas::own(out))
    }
    pub fn quads(&self, options: &QuadsOptions, host: &mut Host) -> Result<Quads, Error> {
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe { obc_polycube_quads_create(self.as_ptr(), &options.0, host, &mut out, error) })?;
        let handle = QuadsHandle::own(out);
        let out = handle.as_ptr();
        let (n, m) = unsafe { (obc_polycube_quads_vertex_count(out), obc_polycube_quads_quad_count(out)) };
        let mut quads = Quads { positions: vec![0.0; 3 * n], polycube: vec![0.0; 3 * n], corners: vec![[0; 4]; m], patches: vec![0; m],
                                triangles: vec![0; n], weights: vec![[0.0; 3]; n] };
        checked(|error| unsafe {
            obc_polycube_quads_copy(out, quads.positions.as_mut_ptr(), quads.polycube.as_mut_ptr(),
                                    quads.corners.as_mut_ptr() as *mut u32, quads.patches.as_mut_ptr(), error)
        })?;
        checked(|error| unsafe {
            obc_polycube_quads_copy_sources(out, quads.triangles.as_mut_ptr(), quads.weights.as_mut_ptr() as *mut f64, error)
        })?;
        Ok(quads)
    }
}

fn parts(starts: &[u32], of: &[u32]) -> Vec<Vec<u32>> {
    starts.windows(2).map(|ends| of[ends[0] as usize..ends[1] as usize].to_vec()).collect()
}

handle!(GraphHandle, obc_polycube_graph, obc_polycube_graph_destroy);
handle!(QuadsHandle, obc_polycube_quads, obc_polycube_quads_destroy);
