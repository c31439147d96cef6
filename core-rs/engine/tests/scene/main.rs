//! What enters and leaves: files, links and recordings, and what is refused.

mod csv;
mod limits;
mod link;
mod mutations;
mod recording;
mod refusals;
mod round_trips;
mod scenes;
