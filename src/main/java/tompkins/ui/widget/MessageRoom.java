package tompkins.ui.widget;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.UIManager;

/**
 * Room that is kept for notes, so that nothing moves when one of them has something to say: the first that has
 * something takes the room of all.
 */
public final class MessageRoom extends Part {

    /**
     * Room for some lines.
     *
     * @param lines the lines that are kept; only a longer message takes more
     * @param notes the notes, that with the most urgent messages first
     */
    public MessageRoom(int lines, Note... notes) {
        super(new JPanel());
        panel.setOpaque(false);
        panel.setLayout(new FirstOnly(lines));
        for (Note note : notes) {
            panel.add(note.component());
        }
    }

    private record FirstOnly(int lines) implements LayoutManager {

        private static Stream<Component> speaking(Container parent) {
            return Stream.of(parent.getComponents()).filter(Component::isVisible);
        }

        @Override
        public Dimension preferredLayoutSize(Container parent) {
            int kept = lines
                    * parent.getFontMetrics(UIManager.getFont("small.font")).getHeight();
            int first = speaking(parent)
                    .findFirst()
                    .map(note -> note.getPreferredSize().height)
                    .orElse(0);
            return new Dimension(0, Math.max(kept, first));
        }

        @Override
        public Dimension minimumLayoutSize(Container parent) {
            return preferredLayoutSize(parent);
        }

        @Override
        public void layoutContainer(Container parent) {
            Component first = speaking(parent).findFirst().orElse(null);
            for (Component note : parent.getComponents()) {
                // those that wait have the same width, so that their heights are known when their turn comes
                note.setBounds(0, 0, parent.getWidth(), note == first ? parent.getHeight() : 0);
            }
        }

        @Override
        public void addLayoutComponent(String name, Component note) {
            // the panel knows its notes
        }

        @Override
        public void removeLayoutComponent(Component note) {
            // the panel knows its notes
        }
    }
}
