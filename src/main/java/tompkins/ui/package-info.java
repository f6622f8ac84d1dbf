/** The window, put together from the parts in its packages. Together they are the only ones that know Swing. */
package tompkins.ui;
