/** The documents in the window, and the list of keys. */
package tompkins.ui.help;
