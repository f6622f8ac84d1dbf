/** The other picture beside the one that is worked on. */
package tompkins.ui.compare;
