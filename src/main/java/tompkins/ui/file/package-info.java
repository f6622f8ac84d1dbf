/** Opening and saving: what is asked, dropped or put on the clipboard, and work that takes a while. */
package tompkins.ui.file;
