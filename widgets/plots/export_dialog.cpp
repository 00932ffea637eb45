#include "widgets/plots/export_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardItemModel>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "widgets/plots/channel_titles.h"

namespace widgets {

namespace {

constexpr int kNameRole = Qt::UserRole;

QString secondsText(double a, double b) {
    return ExportDialog::tr("%1 to %2 s")
        .arg(std::min(a, b), 0, 'f', 2)
        .arg(std::max(a, b), 0, 'f', 2);
}

}  // namespace

ExportDialog::ExportDialog(const simcore::run::Recording& recording,
                           const std::vector<std::string>& plotted, const Times& times,
                           QWidget* parent)
    : QDialog(parent),
      recording_(recording),
      times_(times),
      plotted_(plotted),
      search_(new QLineEdit(this)),
      list_(new QTreeWidget(this)),
      range_(new QComboBox(this)),
      size_(new QLabel(this)) {
    setObjectName("exportDialog");
    setWindowTitle(tr("Export channels as CSV"));
    search_->setObjectName("exportSearch");
    search_->setAccessibleName(tr("Search channels"));
    search_->setPlaceholderText(tr("Search channels: torque, front, ..."));
    search_->setClearButtonEnabled(true);
    list_->setObjectName("exportChannels");
    list_->setAccessibleName(tr("Channels to write"));
    list_->setColumnCount(3);
    list_->setHeaderLabels({tr("Channel"), tr("Unit"), tr("Column")});
    list_->setUniformRowHeights(true);
    list_->header()->setStretchLastSection(true);
    range_->setObjectName("exportRange");
    range_->setAccessibleName(tr("Time to write"));
    const double last = recording_.rows.empty() ? 0.0 : recording_.rows.back().front();
    range_->addItem(
        tr("Visible: %1")
            .arg(secondsText(std::max(0.0, times_.visibleFrom), std::min(last, times_.visibleTo))));
    range_->addItem(times_.mark
                        ? tr("Between the cursors: %1").arg(secondsText(*times_.mark, times_.shown))
                        : tr("Between the cursors (mark one with Shift and a click)"));
    range_->addItem(tr("Whole run: %1").arg(secondsText(0.0, last)));
    if (!times_.mark) {
        qobject_cast<QStandardItemModel*>(range_->model())->item(Cursors)->setEnabled(false);
    }
    range_->setCurrentIndex(times_.mark ? Cursors : Visible);
    size_->setObjectName("exportSize");

    auto* ticks = new QHBoxLayout;
    const auto button = [&](const QString& text, const char* name, auto slot) {
        auto* one = new QPushButton(text);
        one->setObjectName(name);
        one->setAutoDefault(false);
        connect(one, &QPushButton::clicked, this, slot);
        ticks->addWidget(one);
    };
    button(tr("Tick all shown"), "exportAll", [this] { tickShown(true); });
    button(tr("Untick all shown"), "exportNone", [this] { tickShown(false); });
    ticks->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Cancel)->setObjectName("exportCancel");
    write_ = buttons->addButton(tr("Write..."), QDialogButtonBox::AcceptRole);
    write_->setObjectName("exportWrite");
    write_->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(list_, 1);
    layout->addLayout(ticks);
    layout->addWidget(range_);
    layout->addWidget(size_);
    layout->addWidget(buttons);
    makeList(plotted);
    connect(search_, &QLineEdit::textChanged, this, &ExportDialog::filter);
    connect(list_, &QTreeWidget::itemChanged, this, [this] {
        if (!refreshing_) {
            tellSize();
        }
    });
    connect(range_, &QComboBox::currentIndexChanged, this, &ExportDialog::tellSize);
    tellSize();
    resize(620, 560);
}

/// By quantity, with one line for every wheel or joint; of one object it is a line of its own.
void ExportDialog::makeList(const std::vector<std::string>& plotted) {
    std::map<std::string, int> objects;
    for (const auto& channel : recording_.channels) {
        ++objects[channel.quantity];
    }
    std::map<std::string, QTreeWidgetItem*> groups;
    for (std::size_t i = 1; i < recording_.channels.size(); ++i) {  // time always goes along
        const auto& channel = recording_.channels[i];
        const QString title = channelTitle(channel.label);
        const QString unit = QString::fromStdString(channel.unit);
        QTreeWidgetItem* parent = nullptr;
        if (objects[channel.quantity] > 1) {
            QTreeWidgetItem*& group = groups[channel.quantity];
            if (group == nullptr) {
                group = new QTreeWidgetItem(
                    list_, {title, unit, QString::fromStdString(channel.quantity)});
                group->setFlags(group->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsAutoTristate);
                group->setToolTip(0, channelTitle(channel.meaning));
            }
            parent = group;
        }
        auto* item = parent != nullptr ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(list_);
        item->setText(0, parent != nullptr ? QString::fromStdString(channel.object) : title);
        item->setText(1, unit);
        item->setText(2, QString::fromStdString(channel.id()));
        item->setData(0, kNameRole, QString::fromStdString(channel.id()));
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        const bool on = std::find(plotted.begin(), plotted.end(), channel.id()) != plotted.end();
        item->setCheckState(0, on ? Qt::Checked : Qt::Unchecked);
        item->setToolTip(0, channelTitle(channel.meaning));
    }
    // What is ticked is in sight, once the list has its height.
    QTimer::singleShot(0, list_, [list = list_] {
        for (int i = 0; i < list->topLevelItemCount(); ++i) {
            if (list->topLevelItem(i)->checkState(0) != Qt::Unchecked) {
                list->scrollToItem(list->topLevelItem(i), QAbstractItemView::PositionAtTop);
                return;
            }
        }
    });
    list_->setColumnWidth(0, 280);
    list_->setColumnWidth(1, 80);
}

void ExportDialog::filter(const QString& text) {
    const QStringList words = text.split(' ', Qt::SkipEmptyParts);
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* top = list_->topLevelItem(i);
        const auto shows = [&](const QTreeWidgetItem* item) {
            const QString name = top->text(0) + ' ' + item->text(0) + ' ' + item->text(2);
            return std::all_of(words.begin(), words.end(), [&](const QString& word) {
                return name.contains(word, Qt::CaseInsensitive);
            });
        };
        bool any = top->childCount() == 0 && shows(top);
        for (int k = 0; k < top->childCount(); ++k) {
            const bool shown = shows(top->child(k));
            top->child(k)->setHidden(!shown);
            any = any || shown;
        }
        top->setHidden(!any);
        top->setExpanded(!words.isEmpty() && any);
    }
}

void ExportDialog::tickShown(bool on) {
    refreshing_ = true;
    const auto tick = [on](QTreeWidgetItem* item) {
        if (!item->isHidden()) {
            item->setCheckState(0, on ? Qt::Checked : Qt::Unchecked);
        }
    };
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* top = list_->topLevelItem(i);
        for (int k = 0; k < top->childCount() && !top->isHidden(); ++k) {
            tick(top->child(k));
        }
        if (top->childCount() == 0) {
            tick(top);
        }
    }
    refreshing_ = false;
    tellSize();
}

simcore::io::TableCut ExportDialog::cut() const {
    simcore::io::TableCut cut;
    const auto take = [&](const QTreeWidgetItem* item) {
        if (item->data(0, kNameRole).isValid() && item->checkState(0) == Qt::Checked) {
            cut.channels.push_back(item->data(0, kNameRole).toString().toStdString());
        }
    };
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* top = list_->topLevelItem(i);
        take(top);
        for (int k = 0; k < top->childCount(); ++k) {
            take(top->child(k));
        }
    }
    if (range_->currentIndex() == Visible) {
        cut.from = times_.visibleFrom;
        cut.to = times_.visibleTo;
    } else if (range_->currentIndex() == Cursors && times_.mark) {
        cut.from = std::min(*times_.mark, times_.shown);
        cut.to = std::max(*times_.mark, times_.shown);
    }
    return cut;
}

void ExportDialog::tellSize() {
    const simcore::io::TableCut chosen = cut();
    const auto rows = std::count_if(
        recording_.rows.begin(), recording_.rows.end(), [&](const std::vector<double>& row) {
            return (!chosen.from || row.front() >= *chosen.from - 1e-9) &&
                   (!chosen.to || row.front() <= *chosen.to + 1e-9);
        });
    const bool any = !chosen.channels.empty() && rows > 0;
    size_->setText(
        chosen.channels.empty() ? tr("Tick at least one channel.")
        : rows == 0
            ? tr("No recorded instant lies in this time.")
            : tr("%1 columns with the time, %2 rows").arg(chosen.channels.size() + 1).arg(rows));
    write_->setEnabled(any);
}

}  // namespace widgets
