/** The parts of the side panel. */
package tompkins.ui.panel;
