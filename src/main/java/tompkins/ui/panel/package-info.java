/** The parts of the side panel, and the panel that runs a number as an animation. */
package tompkins.ui.panel;
