/**
 * What lessons measure: a measurement that a lesson describes, made with the rays of its picture, and compared with
 * what its formula says.
 */
package tompkins.experiment;
