//! Work outside of Python: without its lock, ended by Ctrl-C, with progress reported on the calling thread.

use std::cell::RefCell;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use asperity::core::cancel::Token;
use asperity::core::task::Task;
use asperity::message::{Code, Fault};
use pyo3::prelude::*;

use crate::failure::Failure;

/// Time between two checks of signals and progress.
const PULSE: Duration = Duration::from_millis(50);
/// Bytes of the stack of a working thread, as the main thread of a command has.
const STACK: usize = 8 << 20;

/// The exception of a law in Python, which ends the work.
type Raised = Arc<Mutex<Option<PyErr>>>;

thread_local! {
    /// Exception of the work that this thread does.
    static RAISED: RefCell<Option<Raised>> = const { RefCell::new(None) };
}

/// The exception of the work of this thread, if it does any.
fn raised<T>(with: impl FnOnce(&mut Option<PyErr>) -> T) -> Option<T> {
    let slot = RAISED.with_borrow(Clone::clone)?;
    let mut slot = slot.lock().unwrap_or_else(PoisonError::into_inner);
    Some(with(&mut slot))
}

/// Whether a law has raised an exception in the work of this thread.
pub fn has_raised() -> bool {
    raised(|slot| slot.is_some()).unwrap_or_default()
}

/// Stores an exception for the caller of the work of this thread.
pub fn raise(error: PyErr) {
    let shown = Python::attach(|py| error.clone_ref(py));
    if raised(|slot| {
        slot.get_or_insert(error);
    })
    .is_none()
    {
        Python::attach(|py| shown.write_unraisable(py, None));
    }
}

/// Progress of the work.
#[derive(Debug, Default)]
pub struct Told {
    done: AtomicUsize,
    total: AtomicUsize,
}

impl Told {
    /// Notes that `done` of `total` steps are made.
    pub fn tell(&self, done: usize, total: usize) {
        self.total.store(total, Ordering::Relaxed);
        self.done.fetch_max(done, Ordering::Relaxed);
    }

    fn now(&self) -> (usize, usize) {
        let of = |count: &AtomicUsize| count.load(Ordering::Relaxed);
        (of(&self.done), of(&self.total))
    }
}

/// Number of threads for a requested one, at most one per core; all cores for none and, as elsewhere in Python, for -1.
fn threads_for(requested: Option<isize>) -> Result<usize, Failure> {
    let cores = thread::available_parallelism().map_or(1, Into::into);
    let Some(requested) = requested.filter(|requested| *requested != -1) else {
        return Ok(cores);
    };
    match usize::try_from(requested) {
        Ok(threads) if threads > 0 => Ok(threads.min(cores)),
        _ => {
            let message = format!("threads = {requested}: must be 1 or more, or -1 for all cores");
            Err(Failure::new(Code::E209, message))
        }
    }
}

/// Does `work` on `threads` threads of its own, all cores where none are named, and calls `progress` with the steps
/// done and their number. What Python raises meanwhile, as KeyboardInterrupt, ends the work.
pub fn in_parallel<T: Send>(
    py: Python<'_>,
    threads: Option<isize>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Told) -> Result<T, Failure> + Send,
) -> PyResult<T> {
    let threads = threads_for(threads)?;
    beside(py, progress, move |told| {
        let raised = RAISED.with_borrow(Clone::clone);
        let task = Task::current();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .stack_size(STACK)
            .start_handler(move |_| RAISED.set(raised.clone()))
            .build();
        let pool = pool.map_err(|error| Failure::from(Fault::internal(error)));
        pool.and_then(|pool| pool.install(|| task.enter(|| work(told))))
    })
}

/// Does `work`, which runs on one thread.
pub fn alone<T: Send>(
    py: Python<'_>,
    work: impl FnOnce() -> Result<T, Failure> + Send,
) -> PyResult<T> {
    beside(py, None, move |_| work())
}

type Done<T> = Result<T, Failure>;

fn beside<T: Send>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Told) -> Done<T> + Send,
) -> PyResult<T> {
    let (token, told) = (Token::new(), Told::default());
    let of_laws = Raised::default();
    let (sender, receiver) = channel::<Done<T>>();
    thread::scope(|scope| {
        let run = |sender: Sender<Done<T>>| {
            RAISED.set(Some(Arc::clone(&of_laws)));
            let done = token.run(|| work(&told));
            // Nobody listens where the caller has failed; then nothing is missed.
            let _ = sender.send(done);
        };
        let builder = thread::Builder::new().stack_size(STACK);
        let worker = builder
            .spawn_scoped(scope, move || run(sender))
            .map_err(|error| Failure::new(Code::E501, format!("no thread to work on: {error}")))?;
        let mut watch = Watch {
            progress,
            told: &told,
            last: None,
        };
        let mut interrupted = None;
        let done = wait(py, receiver, |py| {
            if interrupted.is_none()
                && let Err(error) = watch.look(py)
            {
                interrupted = Some(error);
                token.cancel();
            }
        });
        let joined = py.detach(|| worker.join());
        let of_law = of_laws
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take();
        if let Some(error) = interrupted.or(of_law) {
            return Err(error);
        }
        match (done, joined) {
            (Some(done), Ok(())) => {
                let value = done?;
                watch.tell(py)?;
                Ok(value)
            }
            _ => Err(Failure::new(Code::E501, "the work ended without a result").into()),
        }
    })
}

/// Waits for the end of the work, looking up at every pulse.
fn wait<T: Send>(
    py: Python<'_>,
    receiver: Receiver<Done<T>>,
    mut look: impl FnMut(Python<'_>),
) -> Option<Done<T>> {
    let mut receiver = receiver;
    loop {
        let (back, got) = py.detach(move || {
            let got = receiver.recv_timeout(PULSE);
            (receiver, got)
        });
        receiver = back;
        match got {
            Ok(done) => return Some(done),
            Err(RecvTimeoutError::Disconnected) => return None,
            Err(RecvTimeoutError::Timeout) => look(py),
        }
    }
}

/// Signals and progress.
struct Watch<'a, 'py> {
    progress: Option<&'a Bound<'py, PyAny>>,
    told: &'a Told,
    last: Option<(usize, usize)>,
}

impl Watch<'_, '_> {
    fn look(&mut self, py: Python<'_>) -> PyResult<()> {
        py.check_signals()?;
        self.tell(py)
    }

    fn tell(&mut self, _: Python<'_>) -> PyResult<()> {
        let now = self.told.now();
        if let Some(progress) = self.progress
            && now.1 > 0
            && self.last != Some(now)
        {
            self.last = Some(now);
            progress.call1(now)?;
        }
        Ok(())
    }
}
