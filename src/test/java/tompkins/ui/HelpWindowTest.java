package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JEditorPane;
import javax.swing.SwingUtilities;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.html.HTML;
import javax.swing.text.html.HTMLDocument;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The documents in the window, read with mouse and keys. */
@Timeout(600)
class HelpWindowTest {

    @TempDir
    private Path folder;

    @AutoClose
    private WindowDriver driver;

    private JEditorPane text;

    @BeforeEach
    void open() {
        driver = new WindowDriver(folder, Studios.sphere(), null, List.of());
        driver.menu("menu.tour");
        text = driver.find(JEditorPane.class, "help.text");
        WindowDriver.await("the tour", () -> text.isShowing() && title().equals("A guided tour \u2013 Tompkins"));
    }

    private String title() {
        return ((JDialog) SwingUtilities.getWindowAncestor(text)).getTitle();
    }

    /** Clicks on the first link to an address. */
    private void follow(String address) {
        Point place = WindowDriver.onEventThread(() -> {
            HTMLDocument document = (HTMLDocument) text.getDocument();
            HTMLDocument.Iterator links = document.getIterator(HTML.Tag.A);
            while (!address.equals(href(links.getAttributes()))) {
                links.next();
            }
            Rectangle start = text.modelToView2D(links.getStartOffset() + 1).getBounds();
            text.scrollRectToVisible(start);
            Point onScreen = text.getLocationOnScreen();
            return new Point(onScreen.x + start.x + 2, onScreen.y + start.y + start.height / 2);
        });
        driver.click(place);
    }

    private static String href(AttributeSet link) {
        return (String) link.getAttribute(HTML.Attribute.HREF);
    }

    @Test
    void aLinkToASceneOpensIt() {
        follow("../scenes/fig2a.json");

        WindowDriver.await(
                "Fig. 2(a)", () -> driver.window().model().studio().title().startsWith("Fig. 2(a)"));
        driver.menu("menu.undo");
        assertThat(driver.studio()).as("nothing is lost").isEqualTo(Studios.sphere());
    }

    @Test
    void linksLeadToHeadingsOfOtherPagesAndBackLeadsToWhereTheyWere() {
        follow("conventions.md#rays-run-backwards");

        WindowDriver.await(
                "the chapter", () -> title().equals("Conventions \u2013 Tompkins") && firstLine("Rays run backwards"));
        driver.key(KeyEvent.VK_LEFT, KeyEvent.VK_ALT);
        WindowDriver.await(
                "the tour", () -> title().equals("A guided tour \u2013 Tompkins") && sees("Rays run backwards"));
        assertThat(driver.find(JButton.class, "help.back").isEnabled()).isFalse();
    }

    /** Whether a heading is the first that is seen. */
    private boolean firstLine(String heading) {
        Rectangle seen = text.getVisibleRect();
        int start = text.viewToModel2D(new Point(seen.x, seen.y + 10));
        try {
            return text.getDocument().getText(start, heading.length()).equals(heading);
        } catch (BadLocationException outside) {
            return false;
        }
    }

    private boolean sees(String words) {
        try {
            String all = text.getDocument().getText(0, text.getDocument().getLength());
            return text.getVisibleRect()
                    .contains(text.modelToView2D(all.indexOf(words)).getBounds().getLocation());
        } catch (BadLocationException impossible) {
            throw new AssertionError(impossible);
        }
    }

    /** A page of all pages: they are inside the jar, with their figures. */
    @Test
    void figuresAreShownLineByLine() {
        follow("speed-and-accuracy.md#aperture");
        WindowDriver.await("the studies", () -> title().equals("Speed and accuracy \u2013 Tompkins"));

        follow("speed-and-accuracy/stability.csv");

        WindowDriver.await("the figures", () -> title().equals("# study: stability \u2013 Tompkins"));
    }

    @Test
    void aNewLookIsTaken() {
        driver.menu("look.PROJECTOR");
        int large = WindowDriver.onEventThread(() -> text.getPreferredSize().height);
        assertThat(WindowDriver.onEventThread(() -> text.getFont().getSize())).isGreaterThan(15);
        driver.menu("look.LIGHT");
        assertThat(WindowDriver.onEventThread(() -> text.getPreferredSize().height))
                .isLessThan(large);
        assertThat(title()).isEqualTo("A guided tour \u2013 Tompkins");
    }

    @Test
    void escapeClosesIt() {
        driver.key(KeyEvent.VK_ESCAPE);
        WindowDriver.await("the tour to close", () -> !text.isShowing());
    }
}
