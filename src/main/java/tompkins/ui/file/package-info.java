/** Building blocks for opening and saving: dialogs, files that are dropped, and work that takes a while. */
package tompkins.ui.file;
