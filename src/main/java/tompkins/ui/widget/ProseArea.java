package tompkins.ui.widget;

import javax.swing.UIManager;

/** A field for text of several lines, as high as the text needs. */
@SuppressWarnings("serial") // never written to a stream
public final class ProseArea extends WrappingArea {

    private static final int ROWS = 3;

    private final transient TypedWords words = new TypedWords(this);

    /** An empty field. */
    public ProseArea() {
        super(ROWS);
    }

    /** Lets the keys of undo go back no further than the present text. */
    void forgetTyped() {
        words.forget();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(UIManager.getFont("TextField.font"));
        setBorder(UIManager.getBorder("TextField.border"));
        setMargin(UIManager.getInsets("TextField.margin"));
    }
}
