package tompkins.ui;

import java.util.function.Consumer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import tompkins.property.Descriptions;

/** Controls for a record of a sealed family: a combo box of its types, and under it the form of the chosen one. */
final class FamilyEditor implements ValueEditor {

    private final JPanel panel = Rows.column();
    private final Consumer<Object> commit;
    private final Note note;
    private final JComboBox<Class<?>> types = new JComboBox<>();
    private final Updating updating = new Updating();
    private Class<?> shownType;
    private RecordForm form;

    FamilyEditor(Class<?> family, String name, Note note, Consumer<Object> commit) {
        this.commit = commit;
        this.note = note;
        Descriptions.members(family).forEach(types::addItem);
        types.setRenderer(ValueEditors.renderer(type -> Wording.label((Class<?>) type)));
        types.setName(name);
        types.getAccessibleContext().setAccessibleName(name);
        types.addActionListener(event -> updating.unless(this::choose));
        types.setVisible(types.getItemCount() > 1);
        panel.add(types, "wmin 0");
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public boolean isTall() {
        return true;
    }

    private void choose() {
        Class<?> chosen = (Class<?>) types.getSelectedItem();
        if (chosen != shownType && !ValueEditors.attempt(note, () -> commit.accept(Descriptions.standard(chosen)))) {
            updating.during(() -> types.setSelectedItem(shownType));
        }
    }

    @Override
    public void show(Object value) {
        if (value.getClass() != shownType) {
            shownType = value.getClass();
            updating.during(() -> types.setSelectedItem(shownType));
            types.setToolTipText(Tips.html(Wording.meaning(shownType)));
            replaceForm();
        }
        form.show(value);
    }

    private void replaceForm() {
        if (form != null) {
            panel.remove(form.component());
        }
        form = new RecordForm(shownType, component -> !Branches.isBranch(component.getGenericType()), commit);
        panel.add(form.component(), "wmin 0");
        panel.revalidate();
        panel.repaint();
    }
}
