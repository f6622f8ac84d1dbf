/** What loading, saving and other long work of the window needs, away from the event thread. */
package tompkins.ui.file;
