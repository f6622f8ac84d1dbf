/** Measuring in photographs, by closed formulas and by single rays; and what is told about rays. */
package tompkins.measure;
