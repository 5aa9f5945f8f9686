//! Operators of a solver, cached by grid.

use std::collections::BTreeMap;

use asperity_core::cancel::Cancelled;

use super::few_points::FewPoints;
use super::single_grid;
use super::workspace::{Level, Task, Workspace};
use crate::boundary::Boundary;
use crate::cells::Cells;
use crate::convolution::{Buffers, Convolution};
use crate::grid::{Grid, LARGE_GRID, LineGrid, PlaneGrid};

/// Operators by grid, cached for the grids and windows solved so far. Each has a planner of its own: what a planner
/// has planned before shows in the rounding of its transforms.
pub(crate) struct Levels<G: Grid> {
    grid: G,
    few: FewPoints,
    displacements: BTreeMap<(usize, usize, u64), G::Filter<f64>>,
    singles: BTreeMap<(usize, usize, u64), G::Filter<f32>>,
    inverses: BTreeMap<(usize, usize, u64), G::Filter<f32>>,
}

impl<G: Grid> Default for Levels<G> {
    fn default() -> Self {
        Self {
            grid: G::default(),
            few: FewPoints::default(),
            displacements: BTreeMap::new(),
            singles: BTreeMap::new(),
            inverses: BTreeMap::new(),
        }
    }
}

impl<G: Grid> Levels<G> {
    /// Drops the operators of other sizes before a large grid's are made, which bounds the memory.
    fn make_room(&mut self, cells: Cells) {
        if cells.points() > LARGE_GRID && !self.displacements.contains_key(&cells.key()) {
            self.grid.forget();
            self.displacements.clear();
            self.singles.clear();
            self.inverses.clear();
        }
    }

    /// Displacement operator of a grid; enlarges `buffers` to what it needs.
    fn displacement(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        buffers: &mut Buffers,
    ) -> &G::Filter<f64> {
        self.make_room(cells);
        let grid = &mut self.grid;
        let filter = (self.displacements.entry(cells.key()))
            .or_insert_with(|| grid.displacement(cells, boundary, buffers));
        buffers.reserve(filter);
        filter
    }

    /// Operators of an iteration on a grid; enlarges the buffers of the workspace to what they need.
    fn level(&mut self, cells: Cells, boundary: Boundary, work: &mut Workspace) -> Level<'_, G> {
        self.displacement(cells, boundary, &mut work.buffers);
        let key = cells.key();
        let inverse = (self.inverses.entry(key)).or_insert_with(|| G::inverse(cells));
        work.single_buffers.reserve(inverse);
        let displacement = &self.displacements[&key];
        let single = (self.singles.entry(key)).or_insert_with(|| G::single(displacement));
        work.single_buffers.reserve(single);
        Level {
            displacement,
            single,
            inverse,
            boundary,
        }
    }

    fn minimise(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        (work, task): (&mut Workspace, &Task),
    ) -> Result<usize, Cancelled> {
        if G::RUNS_ARE_PATCHES
            && let Some(sets) = self.few.solve(boundary, work, task)
        {
            return Ok(sets);
        }
        self.iterate(cells, boundary, (work, task))
    }

    /// Improves the pressure of the workspace by iterations.
    pub(crate) fn iterate(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        (work, task): (&mut Workspace, &Task),
    ) -> Result<usize, Cancelled> {
        let level = self.level(cells, boundary, work);
        single_grid::minimise(level, work, task)
    }

    fn refresh(&mut self, cells: Cells, boundary: Boundary, (work, task): (&mut Workspace, &Task)) {
        let displacement = self.displacement(cells, boundary, &mut work.buffers);
        work.list_loaded();
        work.refresh(displacement, task);
    }

    fn displace(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        buffers: &mut Buffers,
        (compliance, pressure): (f64, &[f64]),
    ) {
        let displacement = self.displacement(cells, boundary, buffers);
        displacement.filter(buffers, compliance, pressure);
    }
}

/// The operators of a solver.
pub(crate) enum Operators {
    Line(Levels<LineGrid>),
    Patch(Levels<PlaneGrid>),
}

impl Operators {
    pub(crate) fn new(rows: usize) -> Self {
        match rows {
            1 => Self::Line(Levels::default()),
            _ => Self::Patch(Levels::default()),
        }
    }

    /// Makes the displacement operator of a grid and the buffers that it needs.
    pub(crate) fn prepare(&mut self, cells: Cells, boundary: Boundary, buffers: &mut Buffers) {
        match self {
            Self::Line(levels) => drop(levels.displacement(cells, boundary, buffers)),
            Self::Patch(levels) => drop(levels.displacement(cells, boundary, buffers)),
        }
    }

    /// Improves the pressure of the workspace on a grid. Returns the number of iterations.
    pub(crate) fn minimise(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        work: (&mut Workspace, &Task),
    ) -> Result<usize, Cancelled> {
        match self {
            Self::Line(levels) => levels.minimise(cells, boundary, work),
            Self::Patch(levels) => levels.minimise(cells, boundary, work),
        }
    }

    /// Recomputes the opening of the workspace on a grid.
    pub(crate) fn refresh(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        work: (&mut Workspace, &Task),
    ) {
        match self {
            Self::Line(levels) => levels.refresh(cells, boundary, work),
            Self::Patch(levels) => levels.refresh(cells, boundary, work),
        }
    }

    /// Leaves the displacement by a pressure in the signal of the buffers.
    pub(crate) fn displace(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        buffers: &mut Buffers,
        pressure: (f64, &[f64]),
    ) {
        match self {
            Self::Line(levels) => levels.displace(cells, boundary, buffers, pressure),
            Self::Patch(levels) => levels.displace(cells, boundary, buffers, pressure),
        }
    }
}
