package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JEditorPane;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.RepaintManager;
import javax.swing.SwingUtilities;
import javax.swing.text.BadLocationException;
import javax.swing.text.html.HTML;
import javax.swing.text.html.HTMLDocument;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.studio.Studios;
import tompkins.ui.help.HelpPage;
import tompkins.ui.help.HelpWindow;
import tompkins.ui.widget.Look;

class HelpWindowTest extends WindowFixture {

    private JEditorPane text;

    @BeforeEach
    void open() {
        driver = new WindowDriver(folder, Studios.sphere(), null, List.of());
        driver.menu("menu.tour");
        text = driver.find(JEditorPane.class, "help.text");
        // which keys reach only then
        await("the tour", () -> text.isFocusOwner() && title().equals("A guided tour \u2013 Tompkins"));
    }

    private String title() {
        return ((JDialog) SwingUtilities.getWindowAncestor(text)).getTitle();
    }

    /** Clicks on the first link to an address. */
    private void follow(String address) {
        // at once: a window manager may still move the window
        onEventThread(() -> {
            Rectangle start = placeOf(link(address) + 1).getBounds();
            text.scrollRectToVisible(start);
            for (int event : List.of(MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED, MouseEvent.MOUSE_CLICKED)) {
                Components.mouse(text, event, start.x + 2, start.y + start.height / 2);
            }
        });
    }

    /** The position in the text of the first link to an address. */
    private int link(String address) {
        HTMLDocument.Iterator links = elements(HTML.Tag.A);
        while (!address.equals(links.getAttributes().getAttribute(HTML.Attribute.HREF))) {
            links.next();
        }
        return links.getStartOffset();
    }

    private HTMLDocument.Iterator elements(HTML.Tag tag) {
        return ((HTMLDocument) text.getDocument()).getIterator(tag);
    }

    @Test
    void aLinkToASceneOpensIt() {
        follow("../scenes/fig2a.json");

        await("Fig. 2(a)", () -> driver.studio().title().startsWith("Fig. 2(a)"));
        driver.menu("menu.undo");
        assertThat(driver.studio()).as("nothing is lost").isEqualTo(Studios.sphere());
    }

    @Test
    void aDocumentCoversThePanelsAndOpensWhereItWasLeft() {
        Rectangle owner = driver.window().frame().getBounds();
        Rectangle document = SwingUtilities.getWindowAncestor(text).getBounds();
        assertThat(document.getCenterX()).isGreaterThan(owner.getCenterX());
        Rectangle screen = driver.window().frame().getGraphicsConfiguration().getBounds();
        int lowest = screen.y + screen.height - document.height;
        // but for the title bar that a window manager puts on it, and a task bar
        assertThat(document.y).isCloseTo(Math.max(screen.y, Math.min(owner.y, lowest)), within(80));

        onEventThread(() -> text.scrollRectToVisible(new Rectangle(0, text.getHeight() / 2, 1, 1)));
        int left = onEventThread(() -> text.getVisibleRect().y);
        driver.key(KeyEvent.VK_ESCAPE);
        await("its end", () -> !text.isShowing());
        driver.menu("menu.tour");
        await("the tour", text::isShowing);
        assertThat(onEventThread(() -> text.getVisibleRect().y)).isPositive().isEqualTo(left);
    }

    @Test
    void linksLeadToHeadingsAndBackReturns() {
        follow("conventions.md#rays-run-backwards");

        await("the chapter", () -> title().equals("Conventions \u2013 Tompkins") && firstLine("Rays run backwards"));
        driver.key(KeyEvent.VK_LEFT, KeyEvent.VK_ALT);
        await("the tour", () -> title().equals("A guided tour \u2013 Tompkins") && sees("Rays run backwards"));
        assertThat(driver.find(JButton.class, "help.back").isEnabled()).isFalse();
        // the keys are at the link that was followed
        driver.key(KeyEvent.VK_ENTER);
        await("the chapter again", () -> title().equals("Conventions \u2013 Tompkins"));
    }

    @Test
    void backLeadsToWhereALinkToAHeadingOfTheSamePageStood() {
        driver.menu("menu.sceneFiles");
        await("the reference", () -> title().equals("Scene files \u2013 Tompkins"));
        String link = onEventThread(this::firstLinkWithin);
        follow(link);
        await("the heading", () -> text.getVisibleRect().y > 0);
        Rectangle there = onEventThread(text::getVisibleRect);

        driver.click(driver.find(JButton.class, "help.back"));

        await("where the link is", () -> text.getVisibleRect().y < there.y && sees(link(link)));
        assertThat(title()).isEqualTo("Scene files \u2013 Tompkins");
    }

    @Test
    void wordsAreFoundOneAfterTheOther() {
        driver.menu("menu.sceneFiles");
        await("the reference", () -> title().equals("Scene files \u2013 Tompkins"));
        JTextField words = driver.find(JTextField.class, "Find");
        JLabel found = driver.find(JLabel.class, "help.found");
        int first = onEventThread(() -> all().toLowerCase(Locale.ROOT).indexOf("refracti"));
        int last = onEventThread(() -> all().toLowerCase(Locale.ROOT).lastIndexOf("refracti"));
        assertThat(last).isGreaterThan(first);

        driver.key(KeyEvent.VK_F, KeyEvent.VK_CONTROL);
        await("the focus", words::isFocusOwner);
        onEventThread(() -> words.setText("no such words"));
        driver.key(KeyEvent.VK_ENTER);
        await("no place", () -> found.getText().equals("not found"));
        onEventThread(() -> words.setText("reFRACti"));
        driver.key(KeyEvent.VK_ENTER);
        await("the first place", () -> text.getSelectionStart() == first && sees("efracti"));
        assertThat(found.getText()).isEmpty();
        assertThat(text.getSelectedText()).isEqualToIgnoringCase("refracti");
        driver.key(KeyEvent.VK_ENTER);
        assertThat(onEventThread(text::getSelectionStart)).isGreaterThan(first);
        onEventThread(() -> text.setCaretPosition(last + 1));
        driver.key(KeyEvent.VK_ENTER);
        assertThat(onEventThread(text::getSelectionStart))
                .as("and again the first")
                .isEqualTo(first);
    }

    private String all() {
        try {
            return text.getDocument().getText(0, text.getDocument().getLength());
        } catch (BadLocationException e) {
            throw new AssertionError(e);
        }
    }

    private String firstLinkWithin() {
        HTMLDocument.Iterator links = elements(HTML.Tag.A);
        Object address;
        do {
            address = links.getAttributes().getAttribute(HTML.Attribute.HREF);
            links.next();
        } while (!String.valueOf(address).startsWith("#"));
        return (String) address;
    }

    /** Whether a heading is the first that is seen. */
    private boolean firstLine(String heading) {
        Rectangle seen = text.getVisibleRect();
        return all().startsWith(heading, text.viewToModel2D(new Point(seen.x, seen.y + 10)));
    }

    private boolean sees(String words) {
        return sees(all().indexOf(words));
    }

    private boolean sees(int position) {
        return text.getVisibleRect().contains(placeOf(position).getBounds().getLocation());
    }

    /** A page of all pages: they are inside the jar, with their figures. */
    @Test
    void figuresAreShownLineByLine() {
        follow("speed-and-accuracy.md#aperture");
        await("the studies", () -> title().equals("Speed and accuracy \u2013 Tompkins"));

        follow("speed-and-accuracy/precision.csv");

        await("the figures", () -> title().equals("# study: precision \u2013 Tompkins"));
    }

    @Test
    void theKeysGoFromLinkToLink() {
        driver.key(KeyEvent.VK_TAB);
        driver.key(KeyEvent.VK_TAB);
        driver.key(KeyEvent.VK_TAB, KeyEvent.VK_SHIFT);
        driver.key(KeyEvent.VK_ENTER);
        await("the first scene of the tour", () -> driver.studio().title().startsWith("A town square"));
    }

    @Test
    void picturesKeepApartAndFitIntoANarrowWindow() throws IOException {
        // of the town square in the tour, which would be taken for one
        double gap = onEventThread(() -> {
            HTMLDocument.Iterator images = elements(HTML.Tag.IMG);
            Rectangle2D first = placeOf(images.getStartOffset());
            double right = placeOf(images.getStartOffset() + 1).getX();
            images.next();
            Rectangle2D second = placeOf(images.getStartOffset());
            assertThat(second.getY()).as("in one line").isEqualTo(first.getY());
            return second.getX() - right;
        });
        assertThat(gap).isBetween(4.0, 20.0);
        makeWide(400);
        driver.menu("menu.manual");
        await("the page", () -> title().equals("The window \u2013 Tompkins"));
        makeWide(400);
        // the first picture is that of the window
        BufferedImage picture =
                ImageIO.read(Path.of("docs/pictures/window-default.png").toFile());
        double slope = (double) picture.getHeight() / picture.getWidth();
        await("the small picture", () -> Math.abs(heightOfTheFirstPicture() - 350 * slope) < 60);
        makeWide(600);
        await("the large picture", () -> Math.abs(heightOfTheFirstPicture() - 550 * slope) < 60);
    }

    private Rectangle2D placeOf(int position) {
        try {
            return text.modelToView2D(position);
        } catch (BadLocationException impossible) {
            throw new AssertionError(impossible);
        }
    }

    /** How far it moves down what follows. */
    private double heightOfTheFirstPicture() {
        int picture = elements(HTML.Tag.IMG).getStartOffset();
        return placeOf(all().indexOf("The panel", picture)).getY()
                - placeOf(picture).getY();
    }

    /** Gives the window a width in which nothing is to be scrolled sideways. */
    private void makeWide(int width) {
        onEventThread(() -> SwingUtilities.getWindowAncestor(text).setSize(width, 600));
        await(
                "a text as wide as its window",
                () -> Math.abs(text.getWidth() - width) < 40 && text.getWidth() == text.getVisibleRect().width);
    }

    /** Each frame of the animation in the tour is painted where it stands, though nothing else happens. */
    @Test
    void animationsRun() {
        Point place = onEventThread(() -> {
            HTMLDocument.Iterator images = elements(HTML.Tag.IMG);
            while (!images.getAttributes()
                    .getAttribute(HTML.Attribute.SRC)
                    .toString()
                    .endsWith(".gif")) {
                images.next();
            }
            Rectangle corner = placeOf(images.getStartOffset()).getBounds();
            text.scrollRectToVisible(corner);
            return new Point(corner.x + 20, corner.y + 20);
        });
        AtomicInteger frames = new AtomicInteger();
        RepaintManager.setCurrentManager(new RepaintManager() {
            @Override
            public void addDirtyRegion(JComponent component, int x, int y, int width, int height) {
                if (component == text && new Rectangle(x, y, width, height).contains(place)) {
                    frames.incrementAndGet();
                }
                super.addDirtyRegion(component, x, y, width, height);
            }
        });
        try {
            await("frames", () -> frames.get() > 10);
        } finally {
            RepaintManager.setCurrentManager(null);
        }
    }

    @Test
    void aNewLookIsTaken() {
        driver.menu("look.PROJECTOR");
        int large = onEventThread(() -> text.getPreferredSize().height);
        assertThat(onEventThread(() -> text.getFont().getSize())).isGreaterThan(15);
        driver.menu("look.LIGHT");
        assertThat(onEventThread(() -> text.getPreferredSize().height)).isLessThan(large);
        assertThat(title()).isEqualTo("A guided tour \u2013 Tompkins");
    }

    @Test
    void whatIsOpenedInAnotherLookHasThat() {
        onEventThread(() -> {
            HelpWindow late = new HelpWindow(driver.window().frame(), scene -> {});
            Look.DARK.install();
            late.show(HelpPage.of("tour.md"));
            assertThat(driver.showing(JEditorPane.class)
                            .map(Component::getBackground)
                            .distinct())
                    .as("as in the window that was open when the look changed")
                    .hasSize(1);
            Look.LIGHT.install();
        });
    }
}
