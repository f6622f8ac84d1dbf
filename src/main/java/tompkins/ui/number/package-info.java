/** Numbers of the studio as the window shows and changes them. */
package tompkins.ui.number;
