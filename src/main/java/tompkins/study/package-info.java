/**
 * Speed against accuracy: what each choice of the program costs and what it gains, measured against other methods, with
 * charts, data and sentences. The competitors that the program does not use live here and nowhere else.
 */
package tompkins.study;
