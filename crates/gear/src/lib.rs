//! Involute gear geometry, path of contact, load sharing and loss factors
