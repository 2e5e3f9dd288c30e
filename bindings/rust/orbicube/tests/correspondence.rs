//! Two shapes on one triangulation.

use orbicube::correspondence::{Correspondence, Options};
use orbicube::mesh::Surface;
use orbicube::Host;

#[test]
fn two_shapes_get_one_triangulation() {
    let round = [1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0];
    let stretched: Vec<f64> = round.iter().enumerate().map(|(i, x)| if i % 3 == 0 { 2.0 * x } else { *x }).collect();
    let triangles = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
    let shapes = [Surface::new(&round, &triangles).unwrap(), Surface::new(&stretched, &triangles).unwrap()];
    let both = Correspondence::new(&shapes, &Options::default(), &mut Host::new()).unwrap();
    assert_eq!(both.positions.len(), 2);
    assert_eq!(both.positions[0].len(), both.positions[1].len());
    assert_eq!(both.triangles.len() / 3, 2 * both.positions[0].len() / 3 - 4);
    assert_eq!(both.domain.len(), both.positions[0].len());
    let (_, maps) = Correspondence::with_maps(&shapes, &Options::default(), &mut Host::new()).unwrap();
    let there = maps.map_vertices(0, 1, &mut Host::new()).unwrap();
    let back = maps.map(1, 0, &there, &mut Host::new()).unwrap();
    for v in 0..6 {
        let corner = |k: usize| triangles[3 * back.triangles[v] as usize + k] as usize;
        let x: f64 = (0..3).map(|k| back.weights[v][k] * round[3 * corner(k)]).sum();
        assert!((x - round[3 * v]).abs() < 1e-9);
    }
    assert!(Correspondence::new(&shapes[..1], &Options::default(), &mut Host::new()).is_err());
}
