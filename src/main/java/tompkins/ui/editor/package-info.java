/** Forms for any description, made from what it says about itself, and the editor of the whole scene. */
package tompkins.ui.editor;
