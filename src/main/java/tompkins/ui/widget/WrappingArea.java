package tompkins.ui.widget;

import javax.swing.JTextArea;

/** Text that is wrapped between words and has the height that this needs; Tab leaves it like any other field. */
@SuppressWarnings("serial") // never written to a stream
class WrappingArea extends JTextArea {

    /** An area of any width, with a height of at least some rows; 0 for none. */
    WrappingArea(int rows) {
        super(rows, 1);
        setLineWrap(true);
        setWrapStyleWord(true);
        WrappedText.prepare(this);
    }
}
