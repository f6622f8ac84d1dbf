package tompkins.ui.help;

import java.awt.Color;
import java.awt.Container;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.util.Locale;
import javax.swing.UIManager;
import javax.swing.text.Document;
import javax.swing.text.Element;
import javax.swing.text.StyleConstants;
import javax.swing.text.View;
import javax.swing.text.ViewFactory;
import javax.swing.text.html.HTML;
import javax.swing.text.html.HTMLDocument;
import javax.swing.text.html.HTMLEditorKit;
import javax.swing.text.html.ImageView;
import javax.swing.text.html.ParagraphView;
import javax.swing.text.html.StyleSheet;

/** How the pages of the documents look: in the present look, and if possible no wider than their window. */
@SuppressWarnings("serial") // never written to a stream
final class PageKit extends HTMLEditorKit {

    /** To the left and to the right of the text, in pixels. */
    private static final int MARGIN = 16;

    @Override
    public Document createDefaultDocument() {
        StyleSheet style = new StyleSheet();
        style.addStyleSheet(getStyleSheet());
        style.addRule("body { margin: 4 " + MARGIN + " 16 " + MARGIN + " }");
        style.addRule("a { color: " + css("Tompkins.link") + " }");
        style.addRule("h1 { font-size: 160%; margin: 8 0 8 0 }");
        style.addRule("h2 { font-size: 125%; margin: 16 0 4 0 }");
        style.addRule("pre { margin: 8 0 8 16 }");
        style.addRule("code { font-size: 100% }");
        style.addRule("ul { margin: 4 0 4 24 }");
        style.addRule("th, td { border: 1px solid " + css("Tompkins.line") + "; padding: 3 }");
        return new HTMLDocument(style);
    }

    private static String css(String key) {
        Color colour = UIManager.getColor(key);
        return String.format(Locale.ROOT, "#%06x", colour.getRGB() & 0xffffff);
    }

    @Override
    public ViewFactory getViewFactory() {
        return new HTMLFactory() {
            @Override
            public View create(Element element) {
                Object tag = element.getAttributes().getAttribute(StyleConstants.NameAttribute);
                if (tag == HTML.Tag.IMG) {
                    return new Picture(element);
                }
                // otherwise lines of code would not be broken
                return tag == HTML.Tag.IMPLIED ? new ParagraphView(element) : super.create(element);
            }
        };
    }

    /** A picture that is made smaller, if need be, and stays smooth then. */
    private static final class Picture extends ImageView {

        private double told = 1;

        Picture(Element element) {
            super(element);
            // places in the page must not move later
            setLoadsSynchronously(true);
        }

        /** The factor by which it is smaller; 1 while the width of the text is unknown. */
        private double scale() {
            Container text = getContainer();
            return text == null || text.getWidth() == 0
                    ? 1
                    : Math.min(1, Math.max(1, text.getWidth() - 2 * MARGIN) / super.getPreferredSpan(X_AXIS));
        }

        @Override
        public void setSize(float width, float height) {
            super.setSize(width, height);
            if (told != scale()) {
                told = scale();
                // otherwise the text around it is laid out as if it still had its size in a window of another width
                preferenceChanged(null, true, true);
            }
        }

        @Override
        public float getPreferredSpan(int axis) {
            return (float) (scale() * super.getPreferredSpan(axis));
        }

        @Override
        public float getMinimumSpan(int axis) {
            return axis == X_AXIS ? 1 : super.getMinimumSpan(axis);
        }

        @Override
        public void paint(Graphics graphics, Shape place) {
            Rectangle corner = place.getBounds();
            Graphics2D smaller = (Graphics2D) graphics.create();
            smaller.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
            smaller.translate(corner.x, corner.y);
            smaller.scale(scale(), scale());
            smaller.translate(-corner.x, -corner.y);
            corner.setSize((int) super.getPreferredSpan(X_AXIS), (int) super.getPreferredSpan(Y_AXIS));
            // if it is an animation, it is painted again with each frame
            super.paint(smaller, corner);
            smaller.dispose();
        }
    }
}
