package tompkins.ui.editor;

import java.lang.reflect.RecordComponent;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.JLabel;
import tompkins.property.Descriptions;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Wording;

/**
 * A form for a record, made from its components: names become labels, meanings tooltips, types controls. A value that
 * the record does not accept is marked where it was entered.
 */
public final class RecordForm extends Part {

    /** How far the form of a part stands to the right of its label, in pixels. */
    private static final int INDENT = 16;

    private final Map<RecordComponent, ValueEditor> editors = new LinkedHashMap<>();
    private Object value;

    /**
     * A form for some components of a record type.
     *
     * @param which the components to show
     * @param commit takes the changed record, or throws
     */
    public RecordForm(Class<?> type, Predicate<RecordComponent> which, Consumer<Object> commit) {
        this(type, which, null, commit);
    }

    /** The same, with one note for the messages of all fields, which has its place elsewhere. */
    public RecordForm(Class<?> type, Predicate<RecordComponent> which, Note messages, Consumer<Object> commit) {
        super(Rows.of("wrap 2, hidemode 3, gap 8 5", "[::150,pref][grow,fill]"));
        for (RecordComponent component : Descriptions.components(type)) {
            if (which.test(component)) {
                Note note = messages == null ? new Note("") : messages;
                add(component, note, commit);
                if (messages == null) {
                    panel.add(note.component(), "span, growx, wmin 0");
                }
            }
        }
    }

    private void add(RecordComponent component, Note note, Consumer<Object> commit) {
        ValueEditor editor = ValueEditors.of(
                component, note, part -> commit.accept(Descriptions.with(value, component.getName(), part)));
        editors.put(component, editor);
        JLabel label = new JLabel(Wording.label(component.getName()));
        Naming.tip(label, Wording.meaning(component));
        label.setLabelFor(editor.component());
        panel.add(label, editor.isTall() ? "aligny top, gaptop 3" : "");
        panel.add(editor.component(), "growx, wmin 0");
        editor.parts().ifPresent(parts -> panel.add(parts, "span, growx, wmin 0, gapleft " + INDENT));
    }

    /** Shows a record of the form's type. */
    public void show(Object shown) {
        value = shown;
        editors.forEach((component, editor) -> editor.show(Descriptions.value(component, shown)));
    }
}
