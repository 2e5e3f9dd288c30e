//! Solves A x = b for sparse symmetric positive definite A: by factors that follow small changes of A, or by iterations.
//!
//! ```
//! use orbicube::linear::{Direct, Iterative, Matrix};
//! use orbicube::Host;
//!
//! // A = [2 1; 1 3], its lower triangle.
//! let a = Matrix::from_entries(2, &[(0, 0, 2.0), (1, 0, 1.0), (1, 1, 3.0)])?;
//! let mut factor = Direct::new(&a, &Default::default())?;
//! let x = factor.solve(&[1.0, 2.0])?;
//! assert!((x[0] - 0.2).abs() < 1e-15 && (x[1] - 0.6).abs() < 1e-15);
//! factor.remove_row(1)?; // x[1] is b[1] from now on
//! assert_eq!(factor.solve(&[1.0, 2.0])?, [0.5, 2.0]);
//!
//! let mut solver = Iterative::new(&a, &Default::default(), &mut Host::new())?;
//! let (y, report) = solver.solve(&[1.0, 2.0], &mut Host::new())?;
//! assert!(report.converged == 1 && (y[1] - x[1]).abs() < 1e-7);
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{checked, expect_length, pointer, rows, Error, Host, KeptHost};
use crate::sys::linear::*;

filled!(/// Options of a factor, with their defaults.
    DirectOptions, obc_linear_direct_options, obc_linear_direct_options_init);
filled!(/// Options of iterations, with their defaults.
    IterativeOptions, obc_linear_iterative_options, obc_linear_iterative_options_init);
filled!(/// How iterations ended.
    IterativeReport, obc_linear_iterative_report, obc_linear_iterative_report_init);

/// The lower triangle of a symmetric matrix by rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    row_begin: Vec<usize>,
    columns: Vec<u32>,
    values: Vec<f64>,
}

impl Matrix {
    /// Row i has the entries `row_begin[i]` to `row_begin[i + 1] - 1`; its columns ascend and end with i.
    pub fn new(row_begin: Vec<usize>, columns: Vec<u32>, values: Vec<f64>) -> Result<Matrix, Error> {
        if row_begin.first() != Some(&0) {
            return Err(Error::invalid("row_begin: numbers from 0 to the number of entries are needed"));
        }
        if row_begin.windows(2).any(|pair| pair[0] > pair[1]) {
            return Err(Error::invalid("row_begin descends"));
        }
        let count = row_begin[row_begin.len() - 1];
        expect_length(columns.len(), count, "columns")?;
        expect_length(values.len(), count, "values")?;
        Ok(Matrix { row_begin, columns, values })
    }
    /// Of rows, columns and values of the lower triangle in any order, repeated ones added.
    pub fn from_entries(size: usize, entries: &[(u32, u32, f64)]) -> Result<Matrix, Error> {
        let mut sorted = entries.to_vec();
        sorted.sort_by_key(|entry| (entry.0, entry.1));
        let mut matrix = Matrix { row_begin: vec![0; size + 1], columns: vec![], values: vec![] };
        let mut last = None;
        for (row, column, value) in sorted {
            if row as usize >= size || column > row {
                return Err(Error::invalid(format!("entry ({row}, {column}) is not in the lower triangle of {size} rows")));
            }
            if last == Some((row, column)) {
                *matrix.values.last_mut().expect("an entry") += value;
                continue;
            }
            last = Some((row, column));
            matrix.columns.push(column);
            matrix.values.push(value);
            matrix.row_begin[row as usize + 1] += 1;
        }
        for row in 0..size {
            matrix.row_begin[row + 1] += matrix.row_begin[row];
        }
        Ok(matrix)
    }
    pub fn size(&self) -> usize {
        self.row_begin.len() - 1
    }
    pub fn values(&self) -> &[f64] {
        &self.values
    }
    /// In the order of the rows, to change in place.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }
    fn view(&self) -> obc_linear_matrix {
        obc_linear_matrix {
            size: self.size(),
            row_begin: self.row_begin.as_ptr(),
            columns: pointer(&self.columns),
            values: pointer(&self.values),
        }
    }
}

handle!(DirectHandle, obc_linear_direct, obc_linear_direct_destroy);

/// The factor L D L' of a matrix, for any number of right sides.
pub struct Direct {
    handle: DirectHandle,
    size: usize,
}

// One thread at a time uses it.
unsafe impl Send for Direct {}

impl Direct {
    pub fn new(matrix: &Matrix, options: &DirectOptions) -> Result<Direct, Error> {
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_linear_direct_create(&matrix.view(), &options.0, std::ptr::null(), &mut out, error)
        })?;
        Ok(Direct { handle: DirectHandle::own(out), size: matrix.size() })
    }
    /// Solves A x = b for each of the right sides, which lie one behind the other.
    pub fn solve(&self, right: &[f64]) -> Result<Vec<f64>, Error> {
        if self.size == 0 {
            expect_length(right.len(), 0, "right")?;
            return Ok(vec![]);
        }
        let count = rows(right.len(), self.size, "right")?;
        let mut solution = vec![0.0; right.len()];
        checked(|error| unsafe {
            obc_linear_direct_solve(self.handle.as_ptr(), count, right.as_ptr(), solution.as_mut_ptr(), error)
        })?;
        Ok(solution)
    }
    /// Factorizes a matrix of the same pattern, with values in the order of [`Matrix::values`].
    pub fn refactor(&mut self, values: &[f64]) -> Result<(), Error> {
        checked(|error| unsafe {
            obc_linear_direct_refactor(self.handle.as_ptr(), values.as_ptr(), values.len(), error)
        })
    }
    /// Replaces row and column `row` of the matrix by those of the identity.
    pub fn remove_row(&mut self, row: u32) -> Result<(), Error> {
        checked(|error| unsafe { obc_linear_direct_remove_row(self.handle.as_ptr(), row, error) })
    }
    /// Adds w w' (sign 1), or takes it away (sign -1), for the w with the given entries.
    pub fn update(&mut self, rows: &[u32], values: &[f64], sign: i32) -> Result<(), Error> {
        expect_length(values.len(), rows.len(), "values")?;
        checked(|error| unsafe {
            obc_linear_direct_update(self.handle.as_ptr(), rows.as_ptr(), values.as_ptr(), rows.len(), sign, error)
        })
    }
    /// The number of entries of L below its diagonal.
    pub fn entry_count(&self) -> usize {
        unsafe { obc_linear_direct_entry_count(self.handle.as_ptr()) }
    }
}

handle!(IterativeHandle, obc_linear_iterative, obc_linear_iterative_destroy);

/// Conjugate gradients for a matrix, with symmetric Gauss-Seidel or algebraic multigrid.
pub struct Iterative {
    handle: IterativeHandle, // released before the host that it keeps
    host: KeptHost,
    size: usize,
}

// As of Direct.
unsafe impl Send for Iterative {}

impl Iterative {
    /// The number of threads of the host is that of all solutions.
    pub fn new(matrix: &Matrix, options: &IterativeOptions, host: &mut Host) -> Result<Iterative, Error> {
        let mut kept = KeptHost::new(host.thread_count());
        let mut out = std::ptr::null_mut();
        kept.call(host, |host, error| unsafe {
            obc_linear_iterative_create(&matrix.view(), &options.0, host, &mut out, error)
        })?;
        Ok(Iterative { handle: IterativeHandle::own(out), host: kept, size: matrix.size() })
    }
    /// The solution of A x = b and how it was reached: `report.converged` is 0 where it misses the tolerance.
    pub fn solve(&mut self, right: &[f64], host: &mut Host) -> Result<(Vec<f64>, IterativeReport), Error> {
        expect_length(right.len(), self.size, "right")?;
        let (mut solution, mut report) = (vec![0.0; right.len()], IterativeReport::default());
        let handle = self.handle.as_ptr();
        self.host.call(host, |_, error| unsafe {
            obc_linear_iterative_solve(handle, right.as_ptr(), solution.as_mut_ptr(), &mut report.0, error)
        })?;
        Ok((solution, report))
    }
}
