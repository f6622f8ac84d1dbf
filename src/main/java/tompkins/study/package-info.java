/**
 * Speed against accuracy: what each choice of the program costs and what it gains, measured against other methods, with
 * charts, data and sentences. The other methods, which the program does not use, are only here.
 */
package tompkins.study;
