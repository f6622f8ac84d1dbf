/** The photograph in the window: its picture, captions, notices and the status bar. */
package tompkins.ui.photograph;
