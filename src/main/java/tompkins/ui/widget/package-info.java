/** What the parts of the window are made of: fields that refuse wrong entries, rows, notes, texts, looks. */
package tompkins.ui.widget;
