//! What the modules share: errors, the host, panics that must not pass through C, handles and filled structs.
#![allow(dead_code, unused_macros)] // each feature uses some of it

use std::any::Any;
use std::ffi::CStr;
use std::fmt;
use std::os::raw::{c_char, c_void};
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};

use crate::sys::base::*;

/// What a library refused or failed at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// `OBC_NOT_CLOSED`, ... of [`crate::sys::base`].
    pub status: i32,
    /// One word, such as `not-closed`.
    pub kind: String,
    /// What is wrong and where.
    pub message: String,
}

impl Error {
    pub(crate) fn invalid(message: impl Into<String>) -> Error {
        Error { status: OBC_INVALID_ARGUMENT, kind: "invalid-argument".into(), message: message.into() }
    }
    pub(crate) fn out_of_memory() -> Error {
        Error { status: OBC_OUT_OF_MEMORY, kind: "out-of-memory".into(), message: "an allocation failed".into() }
    }
    /// Whether the progress closure cancelled the work.
    pub fn is_cancelled(&self) -> bool {
        self.status == OBC_CANCELLED
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.kind, self.message)
    }
}

impl std::error::Error for Error {}

/// What a function returns that has a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Evaluation {
    Value(f64),
    /// There is no value here: the method goes on elsewhere. A value that is not finite means the same.
    Failed,
    /// The run ends as cancelled, with the best point so far.
    Stop,
    /// The run ends as cancelled, and this value counts.
    StopAt(f64),
}

impl From<f64> for Evaluation {
    fn from(value: f64) -> Evaluation {
        Evaluation::Value(value)
    }
}

/// `Err` is [`Evaluation::Failed`]: the error is dropped, and the method goes on elsewhere.
impl<E> From<Result<f64, E>> for Evaluation {
    fn from(value: Result<f64, E>) -> Evaluation {
        value.map_or(Evaluation::Failed, Evaluation::Value)
    }
}

/// `None` is [`Evaluation::Failed`].
impl From<Option<f64>> for Evaluation {
    fn from(value: Option<f64>) -> Evaluation {
        value.map_or(Evaluation::Failed, Evaluation::Value)
    }
}

/// What a function returns that only fills arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    Done,
    Failed,
    Stop,
}

impl From<()> for Answer {
    fn from(_: ()) -> Answer {
        Answer::Done
    }
}

/// `Err` is [`Answer::Failed`]: the error is dropped, and the method goes on elsewhere.
impl<E> From<Result<(), E>> for Answer {
    fn from(filled: Result<(), E>) -> Answer {
        filled.map_or(Answer::Failed, Answer::from)
    }
}

impl Evaluation {
    /// Of every solver: continue, stop, failed.
    pub(crate) fn code(self, value: &mut f64) -> i32 {
        match self {
            Evaluation::Value(number) => {
                *value = number;
                0
            }
            Evaluation::Stop => 1,
            Evaluation::StopAt(number) => {
                *value = number;
                1
            }
            Evaluation::Failed => 2,
        }
    }
}

impl Answer {
    pub(crate) fn code(self) -> i32 {
        match self {
            Answer::Done => 0,
            Answer::Stop => 1,
            Answer::Failed => 2,
        }
    }
}

/// Where a computation stands; `total` is 0 where it is not known, `best` NaN where there is none.
#[derive(Clone, Copy, Debug)]
pub struct Progress<'a> {
    pub phase: &'a str,
    pub done: u64,
    pub total: u64,
    pub best: f64,
}

type Panic = Box<dyn Any + Send + 'static>;

/// Holds a panic of a closure that C called.
#[derive(Default)]
pub(crate) struct Caught(Option<Panic>);

impl Caught {
    /// Calls the closure; a panic is kept and returns 1, which every callback takes for "stop".
    pub(crate) fn guard(&mut self, f: impl FnOnce() -> i32) -> i32 {
        if self.0.is_some() {
            return 1;
        }
        match catch_unwind(AssertUnwindSafe(f)) {
            Ok(answer) => answer,
            Err(panic) => {
                self.0 = Some(panic);
                1
            }
        }
    }
    /// Lets a panic go on, on this side of C.
    pub(crate) fn resume(&mut self) {
        if let Some(panic) = self.0.take() {
            resume_unwind(panic);
        }
    }
}

/// What the program lends to a computation: threads, and a closure that receives progress and may cancel.
///
/// ```
/// let mut reports = 0;
/// let mut host = orbicube::Host::new().threads(2).on_progress(|_| {
///     reports += 1;
///     true // go on
/// });
/// ```
#[derive(Default)]
pub struct Host<'a> {
    threads: u32,
    progress: Option<Box<dyn FnMut(Progress<'_>) -> bool + 'a>>,
}

impl<'a> Host<'a> {
    pub fn new() -> Host<'a> {
        Host::default()
    }
    /// 0, the default: one a core. Results do not depend on it.
    pub fn threads(mut self, count: u32) -> Host<'a> {
        self.threads = count;
        self
    }
    pub(crate) fn thread_count(&self) -> u32 {
        self.threads
    }
    /// The closure returns whether to go on. A panic in it stops the work, and goes on when that has ended.
    pub fn on_progress(mut self, f: impl FnMut(Progress<'_>) -> bool + 'a) -> Host<'a> {
        self.progress = Some(Box::new(f));
        self
    }
}

struct Lent<'h, 'a> {
    host: &'h mut Host<'a>,
    caught: Caught,
}

unsafe extern "C" fn report(phase: *const c_char, done: u64, total: u64, best: f64, user: *mut c_void) -> i32 {
    let lent = &mut *(user as *mut Lent);
    let Lent { host, caught } = lent;
    caught.guard(|| {
        let phase = if phase.is_null() { "".into() } else { CStr::from_ptr(phase).to_string_lossy() };
        match host.progress.as_mut() {
            Some(progress) => i32::from(!progress(Progress { phase: &phase, done, total, best })),
            None => 0,
        }
    })
}

/// Calls `f` with a C host and an error to fill, and turns what it returns into a result.
pub(crate) fn call(host: &mut Host, f: impl FnOnce(*const obc_host, *mut obc_error) -> i32) -> Result<(), Error> {
    let mut lent = Lent { host, caught: Caught::default() };
    let mut c: obc_host = unsafe { std::mem::zeroed() };
    unsafe { obc_host_init(&mut c, std::mem::size_of::<obc_host>()) };
    c.thread_count = lent.host.threads;
    if lent.host.progress.is_some() {
        c.progress = Some(report);
        c.progress_user = &mut lent as *mut Lent as *mut c_void;
    }
    let result = checked(|error| f(&c, error));
    lent.caught.resume();
    result
}

/// The host of a handle that keeps it: each report goes to the call that runs. It must live as long as the handle.
pub(crate) struct KeptHost {
    c: obc_host,
    running: *mut *mut c_void, // the Lent of the call that runs, or NULL; in a box of our own, at a place that C knows
}

unsafe extern "C" fn relayed(phase: *const c_char, done: u64, total: u64, best: f64, user: *mut c_void) -> i32 {
    let running = *(user as *mut *mut c_void);
    if running.is_null() {
        return 0;
    }
    report(phase, done, total, best, running)
}

impl KeptHost {
    pub(crate) fn new(threads: u32) -> KeptHost {
        let running: *mut *mut c_void = Box::into_raw(Box::new(std::ptr::null_mut()));
        let mut c: obc_host = unsafe { std::mem::zeroed() };
        unsafe { obc_host_init(&mut c, std::mem::size_of::<obc_host>()) };
        c.thread_count = threads;
        c.progress = Some(relayed);
        c.progress_user = running as *mut c_void;
        KeptHost { c, running }
    }
    /// Calls `f`, of the handle or with the C host for it; reports go to the closure of `host`.
    pub(crate) fn call(&mut self, host: &mut Host, f: impl FnOnce(*const obc_host, *mut obc_error) -> i32) -> Result<(), Error> {
        let mut lent = Lent { host, caught: Caught::default() };
        unsafe { *self.running = &mut lent as *mut Lent as *mut c_void };
        let result = checked(|error| f(&self.c, error));
        unsafe { *self.running = std::ptr::null_mut() };
        lent.caught.resume();
        result
    }
}

impl Drop for KeptHost {
    fn drop(&mut self) {
        drop(unsafe { Box::from_raw(self.running) });
    }
}

/// The same of a function that takes no host.
pub(crate) fn checked(f: impl FnOnce(*mut obc_error) -> i32) -> Result<(), Error> {
    let mut error: obc_error = unsafe { std::mem::zeroed() };
    let status = f(&mut error);
    if status == OBC_OK {
        return Ok(());
    }
    Err(Error { status, kind: text(error.kind.as_ptr()), message: text(error.message.as_ptr()) })
}

/// A text of C; empty for NULL.
pub(crate) fn text(pointer: *const c_char) -> String {
    if pointer.is_null() {
        return String::new();
    }
    unsafe { CStr::from_ptr(pointer) }.to_string_lossy().into_owned()
}

pub(crate) fn c_string(text: &str) -> Result<std::ffi::CString, Error> {
    std::ffi::CString::new(text).map_err(|_| Error::invalid(format!("{text:?} has a zero in it")))
}

/// A path as bytes of the system.
pub(crate) fn c_path(path: &std::path::Path) -> Result<std::ffi::CString, Error> {
    #[cfg(unix)]
    {
        use std::os::unix::ffi::OsStrExt;
        std::ffi::CString::new(path.as_os_str().as_bytes()).map_err(|_| Error::invalid("a path with a zero in it"))
    }
    #[cfg(not(unix))]
    c_string(&path.to_string_lossy())
}

/// How many rows of `columns` numbers an array has.
pub(crate) fn rows(length: usize, columns: usize, what: &str) -> Result<usize, Error> {
    if columns == 0 || length % columns != 0 {
        return Err(Error::invalid(format!("{what}: {length} numbers are no rows of {columns}")));
    }
    Ok(length / columns)
}

pub(crate) fn expect_length(length: usize, wanted: usize, what: &str) -> Result<(), Error> {
    if length != wanted {
        return Err(Error::invalid(format!("{what}: {wanted} entries are needed, not {length}")));
    }
    Ok(())
}

/// NULL for an array of nothing.
pub(crate) fn pointer<T>(array: &[T]) -> *const T {
    if array.is_empty() {
        std::ptr::null()
    } else {
        array.as_ptr()
    }
}

/// A C struct with its defaults, behind Deref.
macro_rules! filled {
    ($(#[$doc:meta])* $name:ident, $c:ty, $init:path) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $name(pub $c);
        impl Default for $name {
            fn default() -> Self {
                let mut it: $c = unsafe { std::mem::zeroed() };
                let status = unsafe { $init(&mut it, std::mem::size_of::<$c>()) };
                assert_eq!(status, 0, "the library does not know the struct");
                $name(it)
            }
        }
        through!($name, $c);
    };
}

/// A C struct that only has its size set.
macro_rules! sized {
    ($(#[$doc:meta])* $name:ident, $c:ty) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $name(pub $c);
        impl Default for $name {
            fn default() -> Self {
                let mut it: $c = unsafe { std::mem::zeroed() };
                it.struct_size = std::mem::size_of::<$c>() as u32;
                $name(it)
            }
        }
        through!($name, $c);
    };
}

macro_rules! through {
    ($name:ident, $c:ty) => {
        impl std::ops::Deref for $name {
            type Target = $c;
            fn deref(&self) -> &$c {
                &self.0
            }
        }
        impl std::ops::DerefMut for $name {
            fn deref_mut(&mut self) -> &mut $c {
                &mut self.0
            }
        }
    };
}

/// A handle that is released when it is dropped.
macro_rules! handle {
    ($(#[$doc:meta])* $name:ident, $c:ty, $destroy:path) => {
        $(#[$doc])*
        pub struct $name {
            handle: std::ptr::NonNull<$c>,
        }
        impl $name {
            /// Owns what a C function has handed out.
            fn own(handle: *mut $c) -> Self {
                $name { handle: std::ptr::NonNull::new(handle).expect("a handle") }
            }
            /// What the C functions take.
            pub fn as_ptr(&self) -> *mut $c {
                self.handle.as_ptr()
            }
        }
        impl Drop for $name {
            fn drop(&mut self) {
                unsafe { $destroy(self.handle.as_ptr()) }
            }
        }
    };
}
