package tompkins.ui.help;

import java.awt.BorderLayout;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JEditorPane;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import javax.swing.event.HyperlinkEvent;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.Element;
import javax.swing.text.html.HTML;
import javax.swing.text.html.HTMLDocument;
import tompkins.io.BundledScenes;
import tompkins.studio.Studio;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Screens;
import tompkins.ui.widget.Texts;

/** Shows the documents that come with the program beside its window; links to scenes open them there. */
public final class HelpWindow {

    /** Size at first, in sizes of the type. */
    private static final double WIDTH = 54;

    private static final double HEIGHT = 60;

    private final JFrame owner;
    private final Consumer<Studio> openScene;
    private final JEditorPane text = new Text();
    private final FindBar find = new FindBar(text);
    private final JButton back = new JButton(Texts.get("help.back"));
    private final Deque<Place> past = new ArrayDeque<>();
    private final JDialog window;
    private HelpPage page;

    /** A page, how far it was scrolled, and which link the keys had reached. */
    private record Place(HelpPage page, Rectangle seen, int caret) {}

    /**
     * A window that is not shown yet.
     *
     * @param openScene shows the scene of a link
     */
    public HelpWindow(JFrame owner, Consumer<Studio> openScene) {
        this.owner = owner;
        this.openScene = openScene;
        window = new JDialog(owner);
        text.setName("help.text");
        text.setEditable(false);
        text.putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
        text.addHyperlinkListener(event -> {
            if (event.getEventType() == HyperlinkEvent.EventType.ACTIVATED) {
                follow(event.getDescription());
            }
        });
        // otherwise Tab would leave the text, and no key would lead to its links
        text.setFocusTraversalKeys(
                KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, Set.of(KeyStroke.getKeyStroke("ctrl TAB")));
        text.setFocusTraversalKeys(
                KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, Set.of(KeyStroke.getKeyStroke("ctrl shift TAB")));
        text.getInputMap().put(KeyStroke.getKeyStroke("TAB"), "next-link-action");
        text.getInputMap().put(KeyStroke.getKeyStroke("shift TAB"), "previous-link-action");
        Keys.bindFocused(text, KeyStroke.getKeyStroke("ENTER"), this::followReached);
        back.setName("help.back");
        back.addActionListener(event -> goBack());
        window.setName("help");
        window.setContentPane(content());
        Keys.bindEscape(window.getRootPane(), () -> window.setVisible(false));
        Keys.bind(window.getRootPane(), KeyStroke.getKeyStroke("alt LEFT"), this::goBack);
        Keys.bind(window.getRootPane(), Keys.ofMenu("ctrl F"), find::begin);
        window.setSize(Look.pixels(WIDTH), Look.pixels(HEIGHT));
        Screens.moveBeside(window, owner);
    }

    /** Shows a page: where it was left if it was the last one, otherwise from its top. */
    public void show(HelpPage wanted) {
        Screens.keepOnScreen(window);
        if (!wanted.equals(page)) {
            goTo(wanted);
        }
        window.setVisible(true);
        window.toFront();
        text.requestFocusInWindow();
    }

    private JPanel content() {
        JPanel content = new JPanel(new BorderLayout());
        JPanel bar = new JPanel(new BorderLayout());
        bar.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
        bar.add(back, BorderLayout.LINE_START);
        bar.add(find.component(), BorderLayout.CENTER);
        content.add(bar, BorderLayout.PAGE_START);
        content.add(
                new JScrollPane(
                        text,
                        ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS,
                        ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED),
                BorderLayout.CENTER);
        return content;
    }

    private void goTo(HelpPage wanted) {
        if (page != null) {
            remember();
        }
        put(wanted);
        text.setCaretPosition(0);
    }

    private void remember() {
        past.push(place());
        back.setEnabled(true);
    }

    private void goBack() {
        if (!past.isEmpty()) {
            put(past.pop());
        }
    }

    private Place place() {
        return new Place(page, text.getVisibleRect(), text.getCaretPosition());
    }

    private void put(Place place) {
        put(place.page);
        text.setCaretPosition(place.caret);
        scrollTo(() -> place.seen);
    }

    private void put(HelpPage shown) {
        page = shown;
        // makes a new document, in the colours of the look
        text.setEditorKit(new PageKit());
        HTMLDocument document = (HTMLDocument) text.getDocument();
        document.setBase(shown.url());
        text.setText(shown.html());
        back.setEnabled(!past.isEmpty());
        window.setTitle(heading(document));
        text.getAccessibleContext().setAccessibleName(window.getTitle());
    }

    private static String heading(HTMLDocument document) {
        try {
            String all = document.getText(0, document.getLength()).strip();
            return Texts.get("help.title", all.lines().findFirst().orElse(""));
        } catch (BadLocationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /** Follows the link that the keys have reached; Swing's own action knows no relative addresses. */
    private void followReached() {
        HTMLDocument document = (HTMLDocument) text.getDocument();
        Object link = document.getCharacterElement(text.getCaretPosition())
                .getAttributes()
                .getAttribute(HTML.Tag.A);
        if (link instanceof AttributeSet address) {
            follow((String) address.getAttribute(HTML.Attribute.HREF));
        }
    }

    /** Opens a scene, or goes to another page or a heading. */
    private void follow(String link) {
        String file = link.replaceFirst("#.*", "");
        String heading = link.substring(file.length()).replace("#", "");
        if (file.endsWith(".json")) {
            openScene.accept(scene(file));
            owner.toFront();
            return;
        }
        if (!file.isEmpty()) {
            goTo(HelpPage.of(file));
        }
        if (!heading.isEmpty()) {
            if (file.isEmpty()) {
                remember();
            }
            scrollTo(() -> placeOf(heading));
        }
    }

    private static Studio scene(String link) {
        try {
            return BundledScenes.studio(Path.of(link).getFileName().toString());
        } catch (IOException missing) {
            throw new UncheckedIOException(missing);
        }
    }

    /** The place of a heading in the text; the present place if there is no heading of this name. */
    private Rectangle placeOf(String heading) {
        Element element = ((HTMLDocument) text.getDocument()).getElement(heading);
        Rectangle seen = text.getVisibleRect();
        if (element == null) {
            return seen;
        }
        try {
            int top = text.modelToView2D(element.getStartOffset()).getBounds().y;
            return new Rectangle(0, top, 1, seen.height);
        } catch (BadLocationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /** Scrolls to a place once the text has been laid out. */
    private void scrollTo(Supplier<Rectangle> place) {
        SwingUtilities.invokeLater(() -> {
            window.validate();
            text.scrollRectToVisible(place.get());
        });
    }

    /** Text that takes the colours of a new look. */
    private final class Text extends JEditorPane {

        private static final long serialVersionUID = 1;

        @Override
        public void updateUI() {
            if (page == null) {
                super.updateUI();
            } else {
                Place place = place();
                super.updateUI();
                put(place);
            }
        }
    }
}
