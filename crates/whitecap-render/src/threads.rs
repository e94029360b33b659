//! Work on all of the processor: rayon's iterators, and on a page, which has one thread, the ordinary ones by the same names.

#[cfg(not(target_arch = "wasm32"))]
pub(crate) use rayon::prelude::*;

#[cfg(target_arch = "wasm32")]
pub(crate) use alone::*;

#[cfg(target_arch = "wasm32")]
mod alone {
    /// As rayon's trait of that name.
    pub(crate) trait IntoParallelIterator: IntoIterator + Sized {
        fn into_par_iter(self) -> Self::IntoIter {
            self.into_iter()
        }
    }

    impl<I: IntoIterator> IntoParallelIterator for I {}

    /// As rayon's traits for what is borrowed.
    pub(crate) trait ParallelSlice<T> {
        fn par_iter(&self) -> std::slice::Iter<'_, T>;
        fn par_iter_mut(&mut self) -> std::slice::IterMut<'_, T>;
    }

    impl<T> ParallelSlice<T> for [T] {
        fn par_iter(&self) -> std::slice::Iter<'_, T> {
            self.iter()
        }

        fn par_iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
            self.iter_mut()
        }
    }
}
