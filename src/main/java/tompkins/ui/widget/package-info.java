/** The building blocks of the window: fields that refuse wrong entries, rows, notes, texts, looks. */
package tompkins.ui.widget;
