//! The laws of the methods, room by room. One program: each more is linked with the whole engine again.

mod absence;
mod adjacency;
mod assignment;
mod avoidance;
mod circles;
mod formations;
mod grouping;
mod hierarchy;
mod join;
mod layers;
mod measure;
mod modes;
mod space;
mod transition;
mod travel;
