/** The window: the photograph, and beside it what the photograph depends on. The only package that knows Swing. */
package tompkins.ui;
