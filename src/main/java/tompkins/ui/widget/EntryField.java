package tompkins.ui.widget;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.awt.Container;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import tompkins.property.InvalidPropertyException;

/**
 * A field for a value that is written as text. It is taken when Enter is pressed (with Ctrl where Enter begins another
 * line) or the focus leaves. A wrong value is marked with what is allowed. A wrong or unfinished text stays until it is
 * corrected or taken back, or until the value is changed elsewhere; a text that is just being typed stays even then.
 */
public final class EntryField {

    static {
        MousePress.watch(EntryField::takeBeforePress);
    }

    private final JTextComponent field;
    private final String tip;
    private final Note note;
    private final Consumer<String> commit;
    private String shown = "";

    /** The text as the field shows it: a field of one line has no line ends. */
    private String displayed = "";

    /**
     * Makes a component a field for a value.
     *
     * @param name what a screen reader calls it
     * @param tip its meaning, unit and range
     * @param note where messages go; fields may share one
     * @param commit takes the text, or throws {@link InvalidPropertyException}; whatever else it throws marks the
     *     field, too, and does not keep what happens after the field is left, such as saving
     */
    public EntryField(JTextComponent field, String name, String tip, Note note, Consumer<String> commit) {
        this.field = field;
        this.tip = tip;
        this.note = note;
        this.commit = commit;
        field.putClientProperty(EntryField.class, this);
        Naming.name(field, name, tip);
        field.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                if (!event.isTemporary()) {
                    commit();
                }
            }
        });
        if (field instanceof JTextField line) {
            line.addActionListener(event -> commit());
            bindRevert(line);
        }
        Keys.bindFocused(field, Keys.CONTROL_ENTER, this::commit);
    }

    /** Binds Escape in fields of one line only, because nobody wants one key to remove many lines. */
    private void bindRevert(JTextField line) {
        line.getInputMap().put(Keys.ESCAPE, "revert");
        line.getActionMap().put("revert", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                revert();
            }

            @Override
            public boolean isEnabled() {
                return isPending();
            }
        });
    }

    /** The field itself, to be put into a panel. */
    public JTextComponent field() {
        return field;
    }

    /** The fields in a container and in the windows that it owns, hidden ones included. */
    public static Stream<EntryField> in(Container container) {
        Stream<Component> inside = Stream.of(container.getComponents());
        Stream<Component> owned =
                container instanceof Window window ? Stream.of(window.getOwnedWindows()) : Stream.of();
        return Stream.concat(inside, owned).flatMap(EntryField::of);
    }

    /** Takes what is typed into the fields of a container; false if one of them was refused. */
    public static boolean takeAll(Container container) {
        List<EntryField> fields = in(container).toList();
        fields.forEach(EntryField::commit);
        return fields.stream().noneMatch(EntryField::isPending);
    }

    /**
     * Takes what is typed before anything is pressed that takes the focus: the focus may leave the field only after the
     * click, and what was typed would then overrule the click.
     */
    private static void takeBeforePress(Component pressed) {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        if (owner instanceof JTextComponent text
                && text.getClientProperty(EntryField.class) instanceof EntryField field
                && pressed != owner
                && pressed instanceof JComponent component
                && component.isEnabled()
                && component.isFocusable()
                && component.isRequestFocusEnabled()
                && SwingUtilities.getWindowAncestor(pressed) == SwingUtilities.getWindowAncestor(owner)) {
            field.commit();
        }
    }

    private static Stream<EntryField> of(Component component) {
        if (component instanceof JTextComponent text
                && text.getClientProperty(EntryField.class) instanceof EntryField field) {
            return Stream.of(field);
        }
        return component instanceof Container container ? in(container) : Stream.of();
    }

    /**
     * Shows the text of a value; keeps what was typed and not taken as long as that text has not changed, or the typing
     * goes on.
     */
    public void show(String text) {
        boolean same = text.equals(shown);
        boolean pending = isPending();
        shown = text;
        if (pending && !same && field.isFocusOwner() && !isWrong()) {
            displayed = text;
        } else if (!pending || !same) {
            revert();
        }
    }

    /** Whether something was typed but not taken, because it was refused or is not finished. */
    public boolean isPending() {
        return isWrong() || !field.getText().equals(displayed);
    }

    private boolean isWrong() {
        return field.getClientProperty(FlatClientProperties.OUTLINE) != null;
    }

    /** Takes what was typed, if it is not what was shown. */
    public void commit() {
        String text = field.getText();
        if (text.equals(displayed)) {
            clear();
            return;
        }
        try {
            commit.accept(text);
            // in the form in which it is shown, however it was typed
            revert();
        } catch (InvalidPropertyException wrong) {
            refuse(Wording.message(wrong));
        } catch (RuntimeException fault) {
            refuse(Messages.of(fault));
            Faults.tell(fault);
        }
    }

    private void refuse(String message) {
        field.putClientProperty(FlatClientProperties.OUTLINE, FlatClientProperties.OUTLINE_ERROR);
        field.getAccessibleContext().setAccessibleDescription(message);
        note.setErrorAfterPress(message);
    }

    /** Shows the value that was there before something was typed. */
    public void revert() {
        if (!field.getText().equals(shown)) {
            boolean selected = field.getText().equals(field.getSelectedText());
            field.setText(shown);
            field.setCaretPosition(0);
            if (selected) {
                // the user is about to type another value
                field.selectAll();
            }
        }
        displayed = field.getText();
        if (field instanceof ProseArea prose) {
            prose.forgetTyped();
        }
        clear();
    }

    private void clear() {
        if (isWrong()) {
            field.putClientProperty(FlatClientProperties.OUTLINE, null);
            field.getAccessibleContext().setAccessibleDescription(tip);
            note.clearAfterPress();
        }
    }
}
