/** Scenes, photographs and texts on their way into the window and out of it: files and the clipboard. */
package tompkins.ui.exchange;
