/** Opening and saving: dialogs, files that are dropped, the clipboard, and work that takes a while. */
package tompkins.ui.file;
