/**
 * Files that are read whole, and that appear whole under their names or not at all: nothing half-written stays,
 * whatever stops the program. Says in words why a file cannot be read or written.
 */
package tompkins.file;
