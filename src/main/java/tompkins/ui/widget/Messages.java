package tompkins.ui.widget;

import java.awt.Component;
import java.awt.Dimension;
import java.util.stream.Collectors;
import javax.swing.JComponent;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import tompkins.property.OneLine;

/** Messages that must not be overlooked. */
public final class Messages {

    private static final int COLUMNS = 60;
    private static final int MOST_ROWS = 26;

    /** What a dialog has above and below its content, in sizes of its type. */
    private static final double FRAME = 12;

    private Messages() {}

    /** Says what went wrong. */
    public static void error(Component parent, String message) {
        show(parent, Texts.get("message.error"), message, JOptionPane.ERROR_MESSAGE);
    }

    /** Shows a message until it is closed. */
    public static void tell(Component parent, String title, String message) {
        show(parent, title, message, JOptionPane.PLAIN_MESSAGE);
    }

    /** Shows a message that is laid out already, with a scroll bar if the screen is too low for it. */
    public static void tell(Component parent, String title, JComponent content) {
        JScrollPane scroll = scroll(content);
        Dimension size = content.getPreferredSize();
        int room = Screens.room(parent).height - Look.pixels(FRAME);
        if (size.height > room) {
            size = new Dimension(size.width + scroll.getVerticalScrollBar().getPreferredSize().width, room);
        }
        scroll.getViewport().setPreferredSize(size);
        scroll.getVerticalScrollBar().setUnitIncrement(Look.pixels(2));
        content.setFocusable(true);
        JOptionPane pane = new JOptionPane(scroll, JOptionPane.PLAIN_MESSAGE) {
            @Override
            public void selectInitialValue() {
                super.selectInitialValue();
                // where the keys scroll
                content.requestFocusInWindow();
            }
        };
        pane.createDialog(parent, title).setVisible(true);
    }

    /** Shows a message with a choice of answers, and returns the number of the answer; closing it gives the last. */
    public static int tellAndAsk(Component parent, String title, String message, String... answers) {
        return ask(
                parent,
                title,
                scroll(text(title, message)),
                JOptionPane.PLAIN_MESSAGE,
                answers,
                answers[answers.length - 1]);
    }

    private static void show(Component parent, String title, String message, int kind) {
        JOptionPane.showMessageDialog(parent, scroll(text(title, message)), title, kind);
    }

    /** A message, which may repeat words from outside. */
    private static JTextArea text(String title, String words) {
        String message = words.lines().map(OneLine::of).collect(Collectors.joining("\n"));
        int longest = message.lines().mapToInt(String::length).max().orElse(1);
        JTextArea text = new JTextArea(
                message, (int) Math.min(MOST_ROWS, lines(message)), Math.max(1, Math.min(COLUMNS, longest)));
        text.setName("message");
        text.getAccessibleContext().setAccessibleName(title);
        text.setEditable(false);
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        text.setOpaque(false);
        return text;
    }

    private static JScrollPane scroll(JComponent content) {
        JScrollPane scroll = new JScrollPane(content);
        scroll.setBorder(null);
        return scroll;
    }

    private static long lines(String message) {
        return message.lines().mapToLong(line -> 1 + line.length() / COLUMNS).sum();
    }

    /** Asks a question; true if the answer is yes. */
    public static boolean confirm(Component parent, String title, String question) {
        return JOptionPane.showConfirmDialog(parent, scroll(text(title, question)), title, JOptionPane.OK_CANCEL_OPTION)
                == JOptionPane.OK_OPTION;
    }

    /** What should happen to changes that were not saved. */
    public enum Unsaved {
        SAVE,
        DISCARD,
        CANCEL
    }

    /** Asks what should happen to changes; closing the question means to cancel. */
    public static Unsaved askAboutChanges(Component parent, String title) {
        int chosen = choose(
                parent,
                Texts.get("unsaved.title"),
                Texts.get("unsaved.question", title),
                Texts.get("unsaved.save"),
                Texts.get("unsaved.discard"),
                Texts.get("task.cancel"));
        return Unsaved.values()[chosen];
    }

    /**
     * Asks for one of some answers and returns its number; Enter gives the first, closing the question the last one.
     */
    public static int choose(Component parent, String title, String question, String... answers) {
        return ask(parent, title, scroll(text(title, question)), JOptionPane.WARNING_MESSAGE, answers, answers[0]);
    }

    private static int ask(
            Component parent, String title, Object content, int kind, String[] answers, String givenByEnter) {
        int chosen = JOptionPane.showOptionDialog(
                parent, content, title, JOptionPane.DEFAULT_OPTION, kind, null, answers, givenByEnter);
        return chosen == JOptionPane.CLOSED_OPTION ? answers.length - 1 : chosen;
    }

    /** Whether memory ran out, in whatever exception that is wrapped. */
    public static boolean isOfMemory(Throwable failure) {
        return failure instanceof OutOfMemoryError || failure.getCause() instanceof OutOfMemoryError;
    }

    /** What an exception says to the user. */
    public static String of(Throwable failure) {
        if (isOfMemory(failure)) {
            return Texts.get("message.memory", Runtime.getRuntime().maxMemory() >> 20);
        }
        return failure.getMessage() == null ? failure.toString() : failure.getMessage();
    }
}
